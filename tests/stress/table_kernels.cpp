// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/table_kernels.hpp"

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "gap/simd/gap_kernels.hpp"
#include "sphere/stored_table.hpp"
#include "table/own_scheme.hpp"
#include "table/packed_fixture.hpp"

namespace impinge::test {
// Tables of a scheme that kernels are made from, and what is asked of all of them.

// Proven of what the kernels of the scheme keep, before any search, mm.
template <class S>
double bound_of(const TriangleMesh& mesh, const RadialTable<S>& radii, Layer layer) {
  if constexpr (std::same_as<S, CubeGnomonic>) {
    return table_bound(mesh, InverseDepthTable<S>(radii), layer, {1.0, 0}).bound_mm;
  } else {
    return table_bound(mesh, radii, layer, {1.0, 0}).bound_mm;
  }
}

// Of the kernel of that table, mm.
template <class Table>
std::vector<double> gaps_of(const Table& table, const std::vector<Vec3>& vertices, const Pose& pose,
                            Surface scanned) {
  using Real = typename Table::Real;
  std::vector<Real> gap(vertices.size());
  scan_gaps(table, packed_vertices<Real>(vertices), pose, scanned, gap);
  return {gap.begin(), gap.end()};
}

// Of one scheme; shared by what it is stored as.
template <class S>
struct Filled {
  RadialTable<S> radii;   // mm
  double bound_mm = 0.0;  // proven, before any search; 0 if it was not asked for
};

// From a mesh.
template <class S>
std::shared_ptr<const Filled<S>> filled(const TriangleMesh& mesh, Layer layer, double precision_deg,
                                        bool bounded) {
  auto radii = fill_exact(mesh, S::with_precision(precision_deg), layer);
  const double bound = bounded ? bound_of(mesh, radii, layer) : 0.0;
  return std::make_shared<const Filled<S>>(Filled<S>{std::move(radii), bound});
}

namespace {

double storage_bound(const auto& scalar) {
  if constexpr (requires { scalar.storage_bound(); }) {
    return scalar.storage_bound();
  } else {
    return 0.0;
  }
}

// Rows of table/packed_table.hpp and of the helix; Scalar keeps the same numbers.
template <class S, PackedValue Value, class Scalar>
class RowsKernel : public TableKernel {
 public:
  RowsKernel(std::string name, std::shared_ptr<const Filled<S>> from)
      : name_(std::move(name)),
        from_(std::move(from)),
        scalar_(from_->radii),
        table_(packed_table<Value>(from_->radii)) {}

  std::string name() const override { return name_; }
  double unit() const override { return sizeof(Real) == 4 ? 0x1p-24 : 0x1p-53; }
  std::vector<double> gaps(const std::vector<Vec3>& vertices, const Pose& pose,
                           Surface scanned) const override {
    return gaps_of(table_, vertices, pose, scanned);
  }
  double radius_at(const Vec3& x) const override { return scalar_.radius_at(x); }

  // u (20 (r + |x|) + (c m + 5) D), and 5 u Q r of a cube in 16 bits
  double rounding(const Vec3& x, double radius) const override {
    const double m = 0.25 * static_cast<double>(from_->radii.scheme().equator_points());
    const double c = std::same_as<S, CubeGnomonic> ? 13.0 : std::same_as<S, Usid> ? 10.0 + 52.0 * m : 28.0;
    const bool coded = std::same_as<S, CubeGnomonic> && sizeof(Value) == 2;
    const double range = coded ? 1.0 + 65534.0 * table_.step / table_.smallest : 0.0;
    const double steps = steps_at(from_->radii, x, 16.0 * unit(), radius);
    return unit() * (20.0 * (radius + x.norm()) + 5.0 * range * radius + (c + 5.0 / m) * steps);
  }
  double bound() const override { return from_->bound_mm + storage_bound(scalar_); }

 private:
  using Real = typename PackedTable<S, Value>::Real;

  std::string name_;
  std::shared_ptr<const Filled<S>> from_;
  Scalar scalar_;
  PackedTable<S, Value> table_;
};

}  // namespace

std::vector<std::unique_ptr<TableKernel>> table_kernels(const TriangleMesh& mesh, Layer layer,
                                                        double precision_deg, bool bounded) {
  using Cube = CubeGnomonic;
  const auto cube = filled<Cube>(mesh, layer, precision_deg, bounded);
  const auto grid = filled<Rsid>(mesh, layer, precision_deg, bounded);
  const auto helix = filled<Usid>(mesh, layer, precision_deg, bounded);
  using Code = std::uint16_t;
  std::vector<std::unique_ptr<TableKernel>> all;
  all.push_back(std::make_unique<RowsKernel<Cube, float, FloatInverseDepthTable<Cube>>>("cube float", cube));
  all.push_back(
      std::make_unique<RowsKernel<Cube, Code, Uint16InverseDepthTable<Cube>>>("cube 16 bits", cube));
  all.push_back(std::make_unique<RowsKernel<Rsid, float, FloatTable<Rsid>>>("rsid float", grid));
  all.push_back(std::make_unique<RowsKernel<Rsid, Code, Uint16Table<Rsid>>>("rsid 16 bits", grid));
  all.push_back(std::make_unique<RowsKernel<Rsid, double, RadialTable<Rsid>>>("rsid double", grid));
  all.push_back(std::make_unique<RowsKernel<Usid, float, FloatTable<Usid>>>("usid float", helix));
  all.push_back(std::make_unique<RowsKernel<Usid, Code, Uint16Table<Usid>>>("usid 16 bits", helix));
  all.push_back(std::make_unique<RowsKernel<Usid, double, RadialTable<Usid>>>("usid double", helix));
  return all;
}

}  // namespace impinge::test
