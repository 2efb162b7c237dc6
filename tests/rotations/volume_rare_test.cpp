// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes of joints whose neutral pose is blocked or on a border, and volumes that end at once or go down to
// the finest cell.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "rotations/volume.hpp"
#include "support/joined.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// A sphere of 12 mm on a shaft turns about a centre 50 mm off, past one of 10 mm: they are in contact in
// rotations that tilt the first to within an angle of the second, a share (1 - cos) / 2 of all. `turned_deg`
// is that tilt in the neutral pose.
struct TwoSpheres {
  static constexpr double kOff = 50.0;
  static constexpr std::array<double, 2> kSize{12.0, 10.0};
  static double angle(double apart) { return 2.0 * std::asin(0.5 * apart / kOff); }
  static double share(double apart) { return 0.5 * (1.0 - std::cos(angle(apart))); }

  explicit TwoSpheres(double turned) {
    const TriangleMesh inner = cup(300.0, 60.0, 100);
    TriangleMesh back = inner;
    for (Vec3& x : back.vertices) x *= 1.1;
    joint = {icosphere(5.0, 1), test::with_back(inner, back)};
    const std::array<Vec3, 2> at{Vec3(std::cos(turned), std::sin(turned), 0.0), Vec3::UnitX()};
    for (std::size_t n = 0; n < 2; ++n) {
      sphere[n] = icosphere(kSize[n], 3);
      double least = kSize[n];
      for (const Face& face : sphere[n].faces)
        least = std::min(least, area_vector(sphere[n], face).normalized().dot(corner(sphere[n], face, 0)));
      within += least;
      for (Vec3& x : sphere[n].vertices) x += kOff * at[n];
    }
  }
  CellTest test() const { return {joint, {}, {{sphere[0]}, {sphere[1]}}}; }

  BallSocketPair joint;
  std::array<TriangleMesh, 2> sphere;
  double within = 0.0;  // mm, the sum of both radii, of spheres that the meshes hold
};

TEST(MotionVolume, OfTwoSpheresIsThatOfTheirTilt) {
  constexpr double kSum = TwoSpheres::kSize[0] + TwoSpheres::kSize[1];
  for (const double apart : {0.0, 20.0, 60.0}) {  // mm, in the neutral pose
    const TwoSpheres spheres(TwoSpheres::angle(apart));
    const MotionVolume volume(spheres.test(), {.width = 0.004});
    const VolumeShares& found = volume.shares();
    EXPECT_LE(found.low(), 1.0 - TwoSpheres::share(spheres.within)) << apart;
    EXPECT_GE(found.high(), 1.0 - TwoSpheres::share(kSum)) << apart;
    EXPECT_LE(found.open, 0.004);
    if (apart < kSum) {
      EXPECT_EQ(found.reachable_low, 0.0) << apart;
      EXPECT_EQ(found.reachable_high, 0.0) << apart;
      EXPECT_EQ(volume.at(Quaternion4::Unit(0)).state, CellState::blocked) << apart;
    } else {
      EXPECT_EQ(found.reachable_low, found.free);
    }
    std::size_t finer = 0;
    volume.for_each([&](const VolumeCell& at) {
      EXPECT_EQ(at.reachable, at.state == CellState::free && apart > kSum);
      if (at.cell.level > 6) ++finer;
    });
    std::printf("%g: %zu cells, %zu finer, open %g\n", apart, found.cells, finer, found.open);
  }
}

// Turns along sides of cells of several sizes: the turn stops at the finest of those that are not free.
TEST(MotionVolume, StopsAtTheFinestCell) {
  const TwoSpheres spheres(TwoSpheres::angle(60.0));
  const MotionVolume volume(spheres.test(), {.width = 0.004});
  std::size_t stopped = 0;
  for (const Vec3& axis : {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, -1, 0), Vec3(1, 0, -1), Vec3(0, -1, -1),
                           Vec3(1, 1, -1), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    JointTurn turn;
    turn.axis = axis.normalized();
    const VolumeLimit limit = volume.limit(turn, 180.0);
    if (!limit.stops) continue;
    ++stopped;
    const double half = 0.5 * limit.low_deg * kDegree;
    const Vec3 across = std::sin(half) * turn.axis;
    const Quaternion4 q(std::cos(half), across.x(), across.y(), across.z());
    std::uint32_t finest = 0;
    for (std::uint32_t k = 0; k < 16; ++k) {  // a little to all sides
      Quaternion4 beside = q;
      for (Eigen::Index c = 0; c < 4; ++c) beside[c] += ((k >> c) & 1U ? 1.0 : -1.0) * 1e-8;
      const VolumeCell at = volume.at(beside);
      if (at.state != CellState::free) finest = std::max(finest, at.cell.level);
    }
    EXPECT_EQ(limit.stops->cell.level, finest) << axis.transpose();
    EXPECT_NE(limit.stops->state, CellState::free);
  }
  EXPECT_GT(stopped, 0U);
}

// All that was known before is free, but for the first eighth of each cell.
TEST(MotionVolume, EndsAtTheFinestCell) {
  const CellTest test({sphere(5.0, 8), cup(26.0, 60.0, 20)}, {0.0, 0.1});
  std::vector<CellVerdict> known(4 + 8 * kFinestCells, {CellState::free, {}});
  known[0].state = CellState::open;
  for (std::size_t level = 0; level < kFinestCells; ++level) known[4 + 8 * level].state = CellState::open;
  const MotionVolume volume(test, {.width = 1e-300, .threads = 1, .known = known});
  const RotationCell last{kFinestCells, 0};
  EXPECT_EQ(volume.shares().cells, known.size());
  EXPECT_NEAR(volume.shares().open, share(last), 1e-9 * share(last));
  EXPECT_NEAR(volume.shares().free, 1.0, kShareError);
  EXPECT_EQ(volume.at(centre(last)).cell, last);
  EXPECT_EQ(volume.at(centre(last)).state, CellState::open);
}

TEST(MotionVolume, OfFourCellsIsOpen) {
  const CellTest test({sphere(5.0, 8), cup(26.0, 60.0, 20)});
  const MotionVolume volume(test, {.width = 0.1, .most_cells = 11});
  EXPECT_EQ(volume.shares().cells, 4U);
  EXPECT_NEAR(volume.shares().open, 1.0, kShareError);
  const VolumeCell found = volume.at({0.1, 0.2, -0.9, 0.3});
  EXPECT_EQ(found.cell, (RotationCell{0, 2}));
  EXPECT_EQ(found.state, CellState::open);
  for (const double largest : {0.0, -1.0, 180.1, std::nan("")})
    EXPECT_EQ(test::thrown<std::invalid_argument>([&] { volume.limit({}, largest); }),
              "motion volume: the largest angle of a motion must be above 0 and up to 180");
}

}  // namespace
}  // namespace impinge
