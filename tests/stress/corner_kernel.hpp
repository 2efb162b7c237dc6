// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of gap/simd/corner_table.hpp, which the library has no scalar table for: one is made of its
// words.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "gap/corner_fixture.hpp"
#include "stress/filled_table.hpp"
#include "stress/table_kernels.hpp"

namespace impinge::test {

// Made from a table of the cube.
class CornerKernel : public TableKernel {
 public:
  explicit CornerKernel(const Filled<CubeGnomonic>& from)
      : bound_mm_(from.bound_mm),
        table_(corner_table(packed_table<float>(from.radii))),
        stored_(stored_radii(table_, from.radii)),
        scalar_(stored_) {}

  std::string name() const override { return "cube by its corners"; }
  double unit() const override { return 0x1p-24; }
  std::vector<double> gaps(const std::vector<Vec3>& vertices, const Pose& pose,
                           Surface scanned) const override {
    return gaps_of(table_, vertices, pose, scanned);
  }
  double radius_at(const Vec3& x) const override { return scalar_.radius_at(x); }

  // u (20 (r + |x|) + 5 Q r + 13 m D) + 2^-15 D
  double rounding(const Vec3& x, double radius) const override {
    const auto m = static_cast<double>(table_.divisions);
    const double steps = steps_at(stored_, x, 16.0 * unit(), radius);
    return unit() * (20.0 * (radius + x.norm()) + 5.0 * range() * radius + 13.0 * steps) +
           0x1p-15 * steps / m;
  }
  // A number is off by step / 2 + u smallest, and by u of itself as a float; a radius by as much of itself.
  double bound() const override {
    const auto least = static_cast<double>(table_.smallest);
    const double off = 0.5 * static_cast<double>(table_.step) / least + 3.0 * unit() * range();
    double largest = 0.0;
    for (const double r : stored_.radii()) largest = std::fmax(largest, r);
    return bound_mm_ + largest * off / (1.0 - std::fmin(off, 0.5));
  }

 private:
  double range() const { return 1.0 + 32767.0 * static_cast<double>(table_.step / table_.smallest); }

  double bound_mm_;
  CornerTable table_;
  RadialTable<CubeGnomonic> stored_;
  InverseDepthTable<CubeGnomonic> scalar_;
};

}  // namespace impinge::test
