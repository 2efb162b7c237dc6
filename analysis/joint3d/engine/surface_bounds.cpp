// SPDX-License-Identifier: GPL-3.0-or-later
// Apart, since the proof takes long to compile.
#include "surface_bounds.hpp"

#include <concepts>
#include <utility>

#include "sphere/scheme_choice.hpp"
#include "sphere/stored_table.hpp"
#include "table/direction_bounds.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

// Enough for a hip made from parameters. The search takes minutes for a whole bone, part of which is seen
// edge-on from the centre, and its cells are bounded without it.
constexpr std::size_t kHalvings = 20'000;

struct BoundSource {
  const TriangleMesh& mesh;
  Layer layer;
  double storage_bound;  // mm
};

template <class Table, class Bounds>
class KeptBounds final : public SurfaceBounds {
 public:
  KeptBounds(Table table, const BoundSource& source)
      : table_(std::move(table)),
        bounds_(source.mesh, table_, source.layer, {.budget = kHalvings}),
        storage_(source.storage_bound) {}

  double at(const Vec3& x) const override { return bounds_.at(x) + storage_; }
  double everywhere() const override { return bounds_.everywhere() + storage_; }

 private:
  Table table_;
  Bounds bounds_;
  double storage_;
};

template <class Floats, class Sixteen, class Table>
double storage_bound(const Table& table, Storage storage) {
  if (storage == Storage::double_precision) return 0.0;
  return storage == Storage::single_precision ? Floats(table).storage_bound()
                                              : Sixteen(table).storage_bound();
}

}  // namespace

std::unique_ptr<SurfaceBounds> bound_table(const TableSettings& settings, const TriangleMesh& mesh,
                                           Layer layer) {
  std::unique_ptr<SurfaceBounds> bounds;
  with_scheme(settings.scheme, [&]<class S>() {
    RadialTable<S> table = fill_exact(mesh, S::with_precision(settings.precision_deg), layer);
    if constexpr (std::same_as<S, CubeGnomonic>) {
      using Inverse = InverseDepthTable<S>;
      Inverse inverse(table);
      const double stored =
          storage_bound<FloatInverseDepthTable<S>, Uint16InverseDepthTable<S>>(table, settings.storage);
      bounds = std::make_unique<KeptBounds<Inverse, FlatDirectionBounds<S>>>(
          std::move(inverse), BoundSource{mesh, layer, stored});
    } else {
      const double stored = storage_bound<FloatTable<S>, Uint16Table<S>>(table, settings.storage);
      bounds = std::make_unique<KeptBounds<RadialTable<S>, DirectionBounds<S>>>(
          std::move(table), BoundSource{mesh, layer, stored});
    }
  });
  return bounds;
}

}  // namespace impinge
