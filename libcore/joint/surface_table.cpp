// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/surface_table.hpp"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <utility>

#include "gap/gap_scan.hpp"
#include "gap/simd/gap_kernels.hpp"
#include "sphere/scheme_choice.hpp"
#include "sphere/stored_table.hpp"
#include "table/direction_bounds.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

// For an interpolant: its table in double, that table's bounds, and whether a kernel scans fewer bits.
template <class S, class Interpolant>
struct Forms {
  using Exact = RadialTable<S>;
  using Bounds = DirectionBounds<S>;
  static constexpr bool has_kernel = std::same_as<S, Rsid>;
};
template <class S>
struct Forms<S, MeshExact> {
  using Exact = InverseDepthTable<S>;
  using Bounds = FlatDirectionBounds<S>;
  static constexpr bool has_kernel = std::same_as<S, CubeGnomonic>;
};

template <SamplingScheme S>
RadialTable<S> filled(const TableSettings& settings, const TriangleMesh& mesh, Layer layer) {
  return fill_exact(mesh, S::with_precision(settings.precision_deg), layer);
}

template <class S, class Interpolant>
class BoundsOf final : public SurfaceBounds {
 public:
  using Exact = typename Forms<S, Interpolant>::Exact;

  BoundsOf(std::shared_ptr<const Exact> table, double storage, std::size_t halvings, const TriangleMesh& mesh,
           Layer layer)
      : table_(std::move(table)), bounds_(mesh, *table_, layer, {.budget = halvings}), storage_(storage) {}

  double at(const Vec3& x) const override { return bounds_.at(x) + storage_; }
  double everywhere() const override { return bounds_.everywhere() + storage_; }

 private:
  std::shared_ptr<const Exact> table_;
  typename Forms<S, Interpolant>::Bounds bounds_;
  double storage_;
};

// `Kept` is the table in double, in fewer bits, or a kernel's.
template <class S, class Interpolant, class Kept>
class KeptTable final : public SurfaceTable {
 public:
  using Exact = typename Forms<S, Interpolant>::Exact;

  KeptTable(Kept kept, std::size_t entries)
      : kept_(std::make_shared<const Kept>(std::move(kept))), entries_(entries) {}

  void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
            std::span<double> gap) override {
    if constexpr (requires { kept_->radius_at(Vec3()); }) {
      scan_gaps(*kept_, vertices.points, pose, scanned, gap);
    } else {
      found_.resize(gap.size());
      scan_gaps(*kept_, vertices.packed, pose, scanned, found_);
      for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = static_cast<double>(found_[i]);
    }
  }

  std::size_t bytes() const override { return kept_->bytes(); }
  std::size_t entries() const override { return entries_; }

  std::unique_ptr<SurfaceBounds> bounds(const TableSettings& settings, const TriangleMesh& mesh,
                                        Layer layer) const override {
    using Bounds = BoundsOf<S, Interpolant>;
    if constexpr (std::same_as<Exact, Kept>) {
      return std::make_unique<Bounds>(kept_, 0.0, settings.halvings, mesh, layer);
    } else {
      RadialTable<S> table = filled<S>(settings, mesh, layer);
      const double storage = settings.storage == Storage::sixteen_bits
                                 ? StoredTable<S, Interpolant, Uint16Values>(table).storage_bound()
                                 : StoredTable<S, Interpolant, FloatValues>(table).storage_bound();
      return std::make_unique<Bounds>(std::make_shared<const Exact>(std::move(table)), storage,
                                      settings.halvings, mesh, layer);
    }
  }

 private:
  std::shared_ptr<const Kept> kept_;
  std::size_t entries_;
  std::vector<float> found_;
};

template <class S, class Interpolant>
std::unique_ptr<SurfaceTable> kept_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer) {
  RadialTable<S> table = filled<S>(settings, mesh, layer);
  const std::size_t entries = table.scheme().size();
  const auto kept = [entries]<class Kept>(Kept made) -> std::unique_ptr<SurfaceTable> {
    return std::make_unique<KeptTable<S, Interpolant, Kept>>(std::move(made), entries);
  };
  using F = Forms<S, Interpolant>;
  if (settings.storage == Storage::double_precision) return kept(typename F::Exact(std::move(table)));
  const bool sixteen = settings.storage == Storage::sixteen_bits;
  if constexpr (F::has_kernel) {
    return sixteen ? kept(packed_table<std::uint16_t>(table)) : kept(packed_table<float>(table));
  } else {
    return sixteen ? kept(StoredTable<S, Interpolant, Uint16Values>(table))
                   : kept(StoredTable<S, Interpolant, FloatValues>(table));
  }
}

}  // namespace

std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer) {
  std::unique_ptr<SurfaceTable> table;
  with_scheme(settings.scheme, [&]<class S>() {
    if constexpr (std::same_as<S, CubeGnomonic>) {
      if (settings.flat_cube) {
        table = kept_table<S, MeshExact>(settings, mesh, layer);
        return;
      }
    }
    table = kept_table<S, Smooth>(settings, mesh, layer);
  });
  return table;
}

std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer) {
  std::vector<float> points;
  with_scheme(settings.scheme, [&]<class S>() {
    const RadialTable<S> table = filled<S>(settings, mesh, layer);
    for (std::size_t i = 0; i < table.scheme().size(); ++i) {
      const double radius = table.radius_of(i);
      if (std::isnan(radius)) continue;
      const Vec3 x = radius * table.scheme().direction(i);
      for (const double coordinate : {x.x(), x.y(), x.z()}) points.push_back(static_cast<float>(coordinate));
    }
  });
  return points;
}

}  // namespace impinge
