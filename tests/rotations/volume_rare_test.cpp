// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes of joints whose neutral pose is blocked or on a border, and volumes that end at once or go down to
// the finest cell.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "rotations/volume.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// A sphere of 12 mm on a shaft turns about a centre 50 mm off, past one of 10 mm: they are in contact in
// rotations that bring the first to within 22 mm of the second. `turned` is the angle between them, radians,
// in the neutral pose.
struct TwoSpheres {
  static constexpr double kOff = 50.0;
  static constexpr std::array<double, 2> kSize{12.0, 10.0};
  static double angle(double apart) { return 2.0 * std::asin(0.5 * apart / kOff); }

  explicit TwoSpheres(double by) : turned(by) {
    const TriangleMesh inner = cup(300.0, 60.0, 100);
    TriangleMesh back = inner;
    for (Vec3& x : back.vertices) x *= 1.1;
    joint = {icosphere(5.0, 1), test::with_back(inner, back)};
    const std::array<Vec3, 2> at{Vec3(std::cos(turned), 0.8 * std::sin(turned), 0.6 * std::sin(turned)),
                                 Vec3::UnitX()};
    for (std::size_t n = 0; n < 2; ++n) {
      sphere[n] = icosphere(kSize[n], 1);
      double least = kSize[n];
      for (const Face& face : sphere[n].faces)
        least = std::min(least, area_vector(sphere[n], face).normalized().dot(corner(sphere[n], face, 0)));
      within += least;
      for (Vec3& x : sphere[n].vertices) x += kOff * at[n];
    }
  }
  double distance(const Eigen::Matrix3d& rotation) const {
    return kOff *
           (rotation * Vec3(std::cos(turned), 0.8 * std::sin(turned), 0.6 * std::sin(turned)) - Vec3::UnitX())
               .norm();
  }
  CellTest test() const { return {joint, {}, {{sphere[0]}, {sphere[1]}}}; }

  BallSocketPair joint;
  std::array<TriangleMesh, 2> sphere;
  double turned;
  double within = 0.0;  // mm, the sum of both radii, of spheres that the meshes hold
};

// These lead straight to the cells of level 5 about the neutral pose, and leave all others out as free.
std::vector<CellVerdict> known_to_the_neutral_pose() {
  constexpr CellVerdict kOpen{CellState::open, {}};
  constexpr CellVerdict kLeftOut{CellState::free, {}};
  std::vector<CellVerdict> known{kOpen, kLeftOut, kLeftOut, kLeftOut};
  known.insert(known.end(), 8, kOpen);
  for (std::uint32_t level = 2; level < 5; ++level) {
    for (std::uint64_t parent = 0; parent < 8; ++parent) {
      for (std::uint64_t k = 0; k < 8; ++k) known.push_back(k == 7 - parent ? kOpen : kLeftOut);
    }
  }
  return known;
}

// Cells about the neutral pose, and what their parts and those of their parents say: beside the distance of
// the spheres. What is free is joined to the neutral pose only if that is free.
TEST(MotionVolume, OfTwoSpheresIsThatOfTheirDistance) {
  constexpr double kSum = TwoSpheres::kSize[0] + TwoSpheres::kSize[1];
  const std::vector<CellVerdict> known = known_to_the_neutral_pose();
  for (const double apart : {16.0, 25.0}) {  // mm, in the neutral pose
    const TwoSpheres spheres(TwoSpheres::angle(apart));
    const MotionVolume volume(spheres.test(),
                              {.width = 1e-9, .most_cells = 1500, .threads = 1, .known = known});
    test::Dice dice(91);
    std::array<std::size_t, 2> said{};
    std::size_t finest = 0;
    volume.for_each([&](const VolumeCell& at) {
      EXPECT_FALSE(apart < kSum && (at.reachable || at.within_reach));
      if (at.cell.level < 5) return;
      finest = std::max<std::size_t>(finest, at.cell.level);
      for (int n = 0; n < 4; ++n) {
        const Quaternion4 q =
            point_of(at.cell, {dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)});
        const CellState state = volume.at(q).state;
        const double distance = spheres.distance(rotation_of(q));
        EXPECT_FALSE(state == CellState::free && distance < spheres.within);
        EXPECT_FALSE(state == CellState::blocked && distance > kSum);
        if (state == CellState::free || state == CellState::blocked) ++said[state == CellState::free ? 0 : 1];
      }
    });
    EXPECT_GE(finest, 6U);
    EXPECT_GT(said[0], 100U);
    EXPECT_GT(said[1], 100U);
    EXPECT_EQ(volume.at(Quaternion4::Unit(0)).state, apart < kSum ? CellState::blocked : CellState::free);
    EXPECT_EQ(volume.shares().reachable_low > 0.0, apart > kSum);
    EXPECT_EQ(volume.shares().reachable_high > 0.0, apart > kSum);
    if (apart < kSum) {
      EXPECT_EQ(volume.limit({.axis = Vec3::UnitX()}, 8.0).high_deg, 0.0);
      continue;
    }
    // Turns along sides of cells stop at the finest cell there that is not free.
    std::size_t stopped = 0;
    for (int k = 0; k < 60; ++k) {
      JointTurn turn;
      turn.axis = dice.vector();
      turn.axis[k % 3] = 0.0;
      turn.axis.normalize();
      const VolumeLimit limit = volume.limit(turn, 8.0);
      if (!limit.stops) continue;
      ++stopped;
      const double half = 0.5 * limit.low_deg * kDegree;
      const Vec3 across = std::sin(half) * turn.axis;
      std::uint32_t level = 0;
      for (std::uint32_t side = 0; side < 8; ++side) {  // a hair to all sides
        const Vec3 hair(side & 1U ? 1e-9 : -1e-9, side & 2U ? 1e-9 : -1e-9, side & 4U ? 1e-9 : -1e-9);
        const Vec3 x = across + hair;
        const VolumeCell at = volume.at({std::cos(half), x.x(), x.y(), x.z()});
        if (at.state != CellState::free) level = std::max(level, at.cell.level);
      }
      EXPECT_EQ(limit.stops->cell.level, level) << turn.axis.transpose();
      EXPECT_NE(limit.stops->state, CellState::free);
    }
    EXPECT_GT(stopped, 0U);
  }
}

// The cells of level 5 are free in parts, but the neutral pose is in blocked ones.
TEST(MotionVolume, ReachesNoFreePartFromABlockedOne) {
  const std::vector<CellVerdict> known = known_to_the_neutral_pose();
  const TwoSpheres spheres(TwoSpheres::angle(18.0));
  const MotionVolume volume(spheres.test(), {.width = 1e-9, .most_cells = 275, .threads = 1, .known = known});
  std::size_t parts = 0;
  volume.for_each([&](const VolumeCell& at) { parts += at.part != nullptr ? 1U : 0U; });
  EXPECT_GT(parts, 0U);
  EXPECT_EQ(volume.at(Quaternion4::Unit(0)).state, CellState::blocked);
  EXPECT_GT(volume.shares().free, 0.9);
  EXPECT_EQ(volume.shares().reachable_low, 0.0);
}

// Cells are joined where one of nine places on their common side is free in both: by the cells alone, in a
// search from the neutral pose that looks across every side of every cell.
std::size_t expect_joined(const MotionVolume& volume) {
  std::vector<VolumeCell> all;
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::size_t> index;
  volume.for_each([&](const VolumeCell& at) {
    index[{at.cell.level, at.cell.number}] = all.size();
    all.push_back(at);
  });
  const auto is_free = [](const VolumeCell& at, const Quaternion4& q) {
    return at.state == CellState::free ||
           (at.part != nullptr && at.part->is_free(CellFrame(at.cell).place(q)));
  };
  std::vector<std::vector<std::size_t>> joined(all.size());
  std::vector<std::size_t> pending;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const RotationCell& cell = all[k].cell;
    if (cell_of(Quaternion4::Unit(0), cell.level).number >> (3 * cell.level) ==
            cell.number >> (3 * cell.level) &&
        CellFrame(cell).place(Quaternion4::Unit(0)).cwiseAbs().maxCoeff() <= 1.0 &&
        is_free(all[k], Quaternion4::Unit(0)))
      pending.push_back(k);
    for (std::size_t side = 0; side < 6; ++side) {
      RotationCell other = beside(cell, side);
      while (other.level > 0 && !index.contains({other.level, other.number})) other = parent(other);
      const auto found = index.find({other.level, other.number});
      if (found == index.end()) continue;  // it is divided
      for (int place = 0; place < 9; ++place) {
        std::array<double, 3> along{};
        along[side / 2] = side % 2 == 1 ? 1.0 : -1.0;
        along[(side / 2 + 1) % 3] = place % 3 - 1;
        along[(side / 2 + 2) % 3] = place / 3 - 1;
        const Quaternion4 q = point_of(cell, along);
        if (!is_free(all[k], q) || !is_free(all[found->second], q)) continue;
        joined[k].push_back(found->second);
        joined[found->second].push_back(k);
      }
    }
  }
  std::vector<bool> reached(all.size(), false);
  for (const std::size_t k : pending) reached[k] = true;
  while (!pending.empty()) {
    const std::size_t k = pending.back();
    pending.pop_back();
    for (const std::size_t other : joined[k]) {
      if (reached[other]) continue;
      reached[other] = true;
      pending.push_back(other);
    }
  }
  double low = 0.0;
  std::size_t parts = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].state == CellState::free) {
      EXPECT_EQ(all[k].reachable, reached[k]) << k;
    }
    if (!reached[k]) continue;
    low += all[k].state == CellState::free ? share(all[k].cell) : all[k].part->free_share;
    if (all[k].part != nullptr) ++parts;
  }
  EXPECT_NEAR(volume.shares().reachable_low, low, 1e-12);
  return parts;
}

TEST(MotionVolume, ReachesWhatSharesAFreePlace) {
  const std::vector<CellVerdict> known = known_to_the_neutral_pose();
  std::size_t parts = 0;
  for (const double apart : {22.2, 23.0}) {
    const TwoSpheres spheres(TwoSpheres::angle(apart));
    const CellTest test = spheres.test();
    for (const std::size_t cells : {275U, 700U})
      parts += expect_joined(
          MotionVolume(test, {.width = 1e-9, .most_cells = cells, .threads = 1, .known = known}));
  }
  EXPECT_GT(parts, 20U);
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
