// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/surface_table.hpp"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "gap/gap_scan.hpp"
#include "kernels/gap_kernels.hpp"
#include "sphere/quantised_table.hpp"
#include "sphere/scheme_choice.hpp"
#include "table/direction_bounds.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

// What goes with a table in double: its forms in fewer bits, and what bounds it.
template <class Exact>
struct Forms;
template <SamplingScheme S>
struct Forms<RadialTable<S>> {
  using Scheme = S;
  using Single = FloatTable<S>;
  using Sixteen = Uint16Table<S>;
  using Bounds = DirectionBounds<S>;
  static constexpr bool has_kernel = std::same_as<S, Rsid>;
};
template <SamplingScheme S>
struct Forms<InverseDepthTable<S>> {
  using Scheme = S;
  using Single = FloatInverseDepthTable<S>;
  using Sixteen = Uint16InverseDepthTable<S>;
  using Bounds = FlatDirectionBounds<S>;
  static constexpr bool has_kernel = std::same_as<S, CubeGnomonic>;
};

template <class Exact>
std::shared_ptr<const Exact> exact_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer) {
  using S = typename Forms<Exact>::Scheme;
  return std::make_shared<const Exact>(fill_exact(mesh, S::with_precision(settings.precision_deg), layer));
}

template <class Exact>
class BoundsOf final : public SurfaceBounds {
 public:
  BoundsOf(std::shared_ptr<const Exact> table, const TableSettings& settings, const TriangleMesh& mesh,
           Layer layer)
      : table_(std::move(table)), bounds_(mesh, *table_, layer, {.budget = settings.halvings}) {
    if (settings.storage == Storage::single_precision)
      storage_ = typename Forms<Exact>::Single(*table_).storage_bound();
    if (settings.storage == Storage::sixteen_bits)
      storage_ = typename Forms<Exact>::Sixteen(*table_).storage_bound();
  }

  double at(const Vec3& x) const override { return bounds_.at(x) + storage_; }
  double everywhere() const override { return bounds_.everywhere() + storage_; }

 private:
  std::shared_ptr<const Exact> table_;
  typename Forms<Exact>::Bounds bounds_;
  double storage_ = 0.0;
};

// Kept is Exact, one of its forms in fewer bits, or a table of the kernels.
template <class Exact, class Kept>
class KeptTable final : public SurfaceTable {
 public:
  KeptTable(std::shared_ptr<const Kept> kept, std::size_t entries)
      : kept_(std::move(kept)), entries_(entries) {}

  void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
            std::span<double> gap) override {
    [[maybe_unused]] const PackedScan<float> packed{vertices.packed, pose, scanned};
    if constexpr (requires { scan_gaps(*kept_, packed, std::span<float>()); }) {
      found_.resize(gap.size());
      scan_gaps(*kept_, packed, found_);
      for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = static_cast<double>(found_[i]);
    } else {
      scan_gaps(*kept_, vertices.points, pose, scanned, gap);
    }
  }

  std::size_t bytes() const override {
    if constexpr (requires { kept_->bytes(); }) {
      return kept_->bytes();
    } else {
      return Kept::bytes(kept_->scheme()) + kept_->rim_cells().bytes();
    }
  }
  std::size_t entries() const override { return entries_; }

  std::unique_ptr<SurfaceBounds> bounds(const TableSettings& settings, const TriangleMesh& mesh,
                                        Layer layer) const override {
    std::shared_ptr<const Exact> exact;
    if constexpr (std::same_as<Exact, Kept>) {
      exact = kept_;
    } else {
      exact = exact_table<Exact>(settings, mesh, layer);
    }
    return std::make_unique<BoundsOf<Exact>>(std::move(exact), settings, mesh, layer);
  }

 private:
  std::shared_ptr<const Kept> kept_;
  std::size_t entries_;
  std::vector<float> found_;
};

template <class Exact>
std::unique_ptr<SurfaceTable> kept_table(std::shared_ptr<const Exact> exact, Storage storage) {
  const std::size_t entries = exact->scheme().size();
  const auto kept = [entries]<class Kept>(Kept table) -> std::unique_ptr<SurfaceTable> {
    return std::make_unique<KeptTable<Exact, Kept>>(std::make_shared<const Kept>(std::move(table)), entries);
  };
  if (storage == Storage::double_precision)
    return std::make_unique<KeptTable<Exact, Exact>>(std::move(exact), entries);
  const bool sixteen = storage == Storage::sixteen_bits;
  if constexpr (Forms<Exact>::has_kernel) {
    return sixteen ? kept(packed_table<std::uint16_t>(*exact)) : kept(packed_table<float>(*exact));
  } else {
    return sixteen ? kept(typename Forms<Exact>::Sixteen(*exact))
                   : kept(typename Forms<Exact>::Single(*exact));
  }
}

}  // namespace

std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer) {
  std::unique_ptr<SurfaceTable> table;
  with_scheme(settings.scheme, [&]<class S>() {
    if constexpr (std::same_as<S, CubeGnomonic>) {
      if (settings.flat_cube) {
        table = kept_table(exact_table<InverseDepthTable<S>>(settings, mesh, layer), settings.storage);
        return;
      }
    }
    table = kept_table(exact_table<RadialTable<S>>(settings, mesh, layer), settings.storage);
  });
  return table;
}

std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer) {
  std::vector<float> points;
  with_scheme(settings.scheme, [&]<class S>() {
    const auto table = exact_table<RadialTable<S>>(settings, mesh, layer);
    for (std::size_t i = 0; i < table->scheme().size(); ++i) {
      const double radius = table->radius_of(i);
      if (std::isnan(radius)) continue;
      const Vec3 x = radius * table->scheme().direction(i);
      for (const double coordinate : {x.x(), x.y(), x.z()}) points.push_back(static_cast<float>(coordinate));
    }
  });
  return points;
}

}  // namespace impinge
