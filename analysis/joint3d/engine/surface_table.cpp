// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_table.hpp"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "gap/gap_scan.hpp"
#include "kernels/gap_kernels.hpp"
#include "sphere/scheme_choice.hpp"
#include "sphere/stored_table.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

// Vertex by vertex. Kept is RadialTable, InverseDepthTable or one of sphere/stored_table.hpp.
template <class Kept>
class KeptTable final : public SurfaceTable {
 public:
  explicit KeptTable(Kept kept) : kept_(std::move(kept)) {}

  void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
            std::span<double> gap) override {
    scan_gaps(kept_, vertices.points, pose, scanned, gap);
  }

  std::size_t bytes() const override {
    if constexpr (requires { kept_.bytes(); }) {
      return kept_.bytes();
    } else {
      return Kept::bytes(kept_.scheme()) + kept_.rim_cells().bytes();
    }
  }

 private:
  Kept kept_;
};

template <SamplingScheme S, class Value>
class KernelTable final : public SurfaceTable {
 public:
  explicit KernelTable(PackedTable<S, Value> table) : table_(std::move(table)) {}

  void scan(const ScannedVertices& vertices, const Pose& pose, Surface scanned,
            std::span<double> gap) override {
    found_.resize(gap.size());
    scan_gaps(table_, vertices.lanes, pose, scanned, found_);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = static_cast<double>(found_[i]);
  }
  std::size_t bytes() const override { return table_.bytes(); }

 private:
  PackedTable<S, Value> table_;
  std::vector<float> found_;
};

template <class Kept>
std::unique_ptr<SurfaceTable> kept(Kept table) {
  return std::make_unique<KeptTable<Kept>>(std::move(table));
}

template <class Value, class Filled>
std::unique_ptr<SurfaceTable> kernel(const Filled& filled) {
  using S = std::remove_cvref_t<decltype(filled.scheme())>;
  return std::make_unique<KernelTable<S, Value>>(packed_table<Value>(filled));
}

template <SamplingScheme S>
std::unique_ptr<SurfaceTable> stored(RadialTable<S> filled, Storage storage) {
  if constexpr (std::same_as<S, CubeGnomonic>) {
    if (storage == Storage::double_precision) return kept(InverseDepthTable<S>(filled));
    return storage == Storage::sixteen_bits ? kernel<std::uint16_t>(filled) : kernel<float>(filled);
  } else {
    if (storage == Storage::double_precision) return kept(std::move(filled));
    const bool sixteen = storage == Storage::sixteen_bits;
    if constexpr (std::same_as<S, Rsid>) {
      return sixteen ? kernel<std::uint16_t>(filled) : kernel<float>(filled);
    } else {
      return sixteen ? kept(Uint16Table<S>(filled)) : kept(FloatTable<S>(filled));
    }
  }
}

template <SamplingScheme S>
std::vector<float> points_of(const RadialTable<S>& table) {
  std::vector<float> points;
  const S& scheme = table.scheme();
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const double radius = table.radius_of(i);
    if (std::isnan(radius)) continue;
    const Vec3 x = radius * scheme.direction(i);
    for (const double coordinate : {x.x(), x.y(), x.z()}) points.push_back(static_cast<float>(coordinate));
  }
  return points;
}

}  // namespace

std::unique_ptr<SurfaceTable> fill_table(const TableSettings& settings, const TriangleMesh& mesh,
                                         Layer layer) {
  std::unique_ptr<SurfaceTable> table;
  with_scheme(settings.scheme, [&]<class S>() {
    RadialTable<S> filled = fill_exact(mesh, S::with_precision(settings.precision_deg), layer);
    const std::size_t entries = filled.scheme().size();
    table = stored(std::move(filled), settings.storage);
    table->entries = entries;
  });
  return table;
}

std::vector<float> sample_points(const TableSettings& settings, const TriangleMesh& mesh, Layer layer) {
  std::vector<float> points;
  with_scheme(settings.scheme, [&]<class S>() {
    points = points_of(fill_exact(mesh, S::with_precision(settings.precision_deg), layer));
  });
  return points;
}

}  // namespace impinge
