// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/scan_source.hpp"

#include <cmath>
#include <utility>

namespace impinge {
namespace {

// A table where it keeps the accuracy, and the faces themselves elsewhere: beyond the bound and next to a
// rim.
class AccurateSource final : public RadiusSource {
 public:
  AccurateSource(const NearFaces& faces, const TableChoice& choice, std::unique_ptr<PartialTable> table,
                 Layer layer)
      : faces_(faces), choice_(choice), table_(std::move(table)), layer_(layer) {}

  double radius_at(const Vec3& x) const override {
    const NearFaces::Near near = faces_.near(x);
    if (near.nothing()) return kNoSurface;
    if (table_ && keeps_accuracy(choice_, table_->storage_bound(), near)) {
      const double radius = table_->radius_at(x);
      if (!std::isnan(radius)) return radius;
    }
    return faces_.radius(x.normalized(), near, layer_);
  }
  std::size_t bytes() const override { return table_ ? table_->bytes() : 0; }
  std::size_t entries() const override { return table_ ? table_->entries() : 0; }

 private:
  const NearFaces& faces_;
  const TableChoice& choice_;
  std::unique_ptr<PartialTable> table_;
  Layer layer_;
};

}  // namespace

std::unique_ptr<RadiusSource> make_scan_source(const BallSocketPair& joint, const ScenePlan& plan,
                                               const ScanPlan& scan, const FillFull& fill_full) {
  const Layer layer = facing_layer(other(scan.scanned));
  if (!scan.entries) return fill_full(mesh_of(joint, other(scan.scanned)), layer);
  if (!plan.table.accuracy_mm) return fill_partial(*scan.faces, plan.table.scheme, *scan.entries, layer);
  std::unique_ptr<PartialTable> table;
  if (!plan.table.rays_only) {
    table = fill_partial(*scan.faces, plan.table.scheme, *scan.entries, layer);
    table->store(plan.table.storage);
  }
  return std::make_unique<AccurateSource>(*scan.faces, plan.table, std::move(table), layer);
}

}  // namespace impinge
