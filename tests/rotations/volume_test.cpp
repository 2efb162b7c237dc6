// SPDX-License-Identifier: GPL-3.0-or-later
// The volume brackets what is known of a joint: a closed form, random rotations asked of the exact overlay,
// the limits of its turns; and hangs on nothing but the joint and the settings.
#include "rotations/volume.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
#include "phantoms/phantom.hpp"
#include "support/cone_neck.hpp"
#include "support/dice.hpp"
#include "support/exact_touch.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

// The share of rotations that tilt +z by less than a is (1 - cos a) / 2. The wall of a cone is edge-on and no
// surface of its own; its rims are. They have many sides, so that the angle of the meshes is larger by less
// than their sagittas: by 1 - cos(pi / sides) of the tangents of neck and rim.
TEST(MotionVolume, OfAConeNeckIsThatOfItsTilt) {
  for (const double neck_deg : {20.0, 35.0}) {
    const double neck = neck_deg * kDegree;
    const double opening = 80.0 * kDegree;
    const std::size_t sides = 60;
    const BallSocketPair joint = test::cone_neck(neck, opening, sides);
    const MotionVolume volume(CellTest(joint), {.width = 0.2});
    const VolumeShares& found = volume.shares();
    const double tilt = opening - neck;
    const double narrow = std::atan(std::tan(neck) * std::cos(kPi / sides));
    const double wide = std::atan(std::tan(opening) / std::cos(kPi / sides));
    EXPECT_LE(found.open, 0.2);
    EXPECT_LE(found.low(), 0.5 * (1.0 - std::cos(wide - narrow)));
    EXPECT_GE(found.high(), 0.5 * (1.0 - std::cos(tilt)));
    EXPECT_EQ(found.unknown, 0.0);
    EXPECT_EQ(found.reachable_low, found.free);
    EXPECT_NEAR(found.free + found.blocked + found.unknown + found.open, 1.0, kShareError);
  }
}

// Random rotations asked of the exact overlay, of a hip without a symmetry.
TEST(TheoremVolume, BracketsTheShareOfRandomRotations) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  const MotionVolume volume(CellTest(joint), {.width = 0.15});
  test::ExactTouch overlay(joint);
  test::Dice dice(5);
  std::size_t free = 0;
  const std::size_t draws = random_cases();
  for (std::size_t k = 0; k < draws; ++k) {
    const Quaternion4 q = dice.quaternion();
    const bool impinged = overlay.impinged({rotation_of(q), Vec3::Zero()});
    const VolumeCell cell = volume.at(q);
    EXPECT_FALSE(cell.state == CellState::free && impinged);
    EXPECT_FALSE(cell.state == CellState::blocked && !impinged);
    free += impinged ? 0 : 1;
  }
  const double found = static_cast<double>(free) / static_cast<double>(draws);
  const double deviation = 5.0 * 0.5 / std::sqrt(static_cast<double>(draws));
  EXPECT_GE(found, volume.shares().low() - deviation);
  EXPECT_LE(found, volume.shares().high() + deviation);
}

TEST(MotionVolume, LimitsAgreeWithThoseOfTurns) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  const MotionVolume volume(CellTest(joint), {.width = 0.05});
  const TurnLimits limits(joint);
  for (const NamedMotion& motion : named_motions()) {
    const JointTurn turn = joint_turn(motion.start, motion_name(motion.growing), Side::left);
    const VolumeLimit read = volume.limit(turn, 120.0);
    const TurnLimit exact = limits.first_contact(turn, 120.0);
    EXPECT_LE(read.low_deg, exact.high_deg + 1e-6) << motion.name;
    if (read.high_deg) {
      EXPECT_GE(*read.high_deg, exact.low_deg - 1e-6) << motion.name;
    }
    if (exact.state == LimitState::blocked) continue;
    EXPECT_EQ(read.stops.has_value(), read.low_deg < 120.0);
    EXPECT_GT(read.low_deg, exact.low_deg - 45.0) << motion.name;
  }
}

// Whatever the number of threads, and whatever was known before.
TEST(MotionVolume, IsTheSameAgain) {
  const Hip hip = make_hip(hip_preset("normal"), 1000);
  const CellTest test({hip.ball, hip.socket});
  const auto cells = [&](std::size_t threads, std::span<const CellVerdict> known,
                         std::vector<CellVerdict>& reached) {
    VolumeSettings settings = {.width = 0.15};
    settings.threads = threads;
    settings.known = known;
    settings.reached = [&](std::span<const CellVerdict> batch, double) {
      reached.insert(reached.end(), batch.begin(), batch.end());
    };
    std::vector<std::pair<RotationCell, CellState>> found;
    MotionVolume(test, settings).for_each([&](const VolumeCell& at) {
      found.emplace_back(at.cell, at.state);
    });
    return found;
  };
  std::vector<CellVerdict> reached;
  std::vector<CellVerdict> again;
  const auto once = cells(1, {}, reached);
  EXPECT_EQ(cells(3, {}, again), once);
  ASSERT_EQ(reached.size(), again.size());
  for (std::size_t k = 0; k < reached.size(); ++k) {
    EXPECT_EQ(reached[k].state, again[k].state);
    EXPECT_EQ(reached[k].hint, again[k].hint);
  }
  std::vector<CellVerdict> third;
  EXPECT_EQ(cells(2, std::span(reached).first(reached.size() / 3), third), once);
}

// Of a width at which open cells are taken apart. Rotations are drawn from these cells, a third of them moved
// onto a plane of a part, where a wrong one would be found first. Any number of threads gives the same parts,
// also where verdicts were known; limits that are read off them hold those of turns.
TEST(MotionVolume, PartsOfCellsAreFreeAndBlocked) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  const CellTest test(joint);
  std::vector<CellVerdict> reached;
  double open = 0.0;
  VolumeSettings settings = {.width = 0.03, .threads = 1};
  settings.reached = [&](std::span<const CellVerdict> batch, double left) {
    reached.insert(reached.end(), batch.begin(), batch.end());
    open = left;
  };
  const MotionVolume volume(test, settings);
  EXPECT_NEAR(open, volume.shares().open, 1e-9);
  const MotionVolume again(test, {.width = 0.03, .threads = 3, .known = std::span(reached).first(20000)});
  EXPECT_EQ(again.shares().free, volume.shares().free);
  EXPECT_EQ(again.shares().blocked, volume.shares().blocked);
  EXPECT_EQ(again.shares().reachable_low, volume.shares().reachable_low);
  EXPECT_EQ(again.shares().cells, volume.shares().cells);
  std::vector<VolumeCell> parted;
  double whole = 0.0;
  volume.for_each([&](const VolumeCell& at) {
    if (at.part != nullptr) parted.push_back(at);
    if (at.state == CellState::free) whole += share(at.cell);
  });
  EXPECT_GT(volume.shares().free, whole + 0.005);
  test::ExactTouch overlay(joint);
  test::Dice dice(35);
  std::array<std::size_t, 2> asked{};
  for (std::size_t k = 0; k < 10 * random_cases(); ++k) {
    const VolumeCell& at =
        parted[static_cast<std::size_t>(dice.whole(0, static_cast<int>(parted.size()) - 1))];
    Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
    const std::vector<CellPlane>& planes = k % 2 == 0 ? at.part->free : at.part->blocked;
    if (k % 3 == 0 && !planes.empty()) {
      const CellPlane& plane = planes[k % planes.size()];
      const Vec3 slope(plane.slope[0], plane.slope[1], plane.slope[2]);
      t -= (plane.at(t) - 1e-7) * slope / slope.squaredNorm();
      t = t.cwiseMax(-1.0).cwiseMin(1.0);
    }
    const Quaternion4 q = point_of(at.cell, {t[0], t[1], t[2]});
    const CellState state = volume.at(q).state;
    if (state != CellState::free && state != CellState::blocked) continue;
    EXPECT_EQ(overlay.impinged({rotation_of(q), Vec3::Zero()}), state == CellState::blocked)
        << at.cell.level << " " << at.cell.number << " " << t.transpose();
    ++asked[state == CellState::free ? 0 : 1];
  }
  EXPECT_GT(asked[0], random_cases());
  EXPECT_GT(asked[1], random_cases());
  const TurnLimits limits(joint);
  for (const NamedMotion& motion : named_motions()) {
    const JointTurn turn = joint_turn(motion.start, motion_name(motion.growing), Side::left);
    const VolumeLimit read = volume.limit(turn, 120.0);
    const TurnLimit exact = limits.first_contact(turn, 120.0);
    EXPECT_LE(read.low_deg, exact.high_deg + 1e-6) << motion.name;
    EXPECT_GE(read.high_deg.value_or(180.0), exact.low_deg - 1e-6) << motion.name;
  }
}

// A ball that is a cap of 60 degrees about +z under a socket that covers 20 degrees about it: after a tilt of
// 40 the socket sees beyond the mesh, where nothing touches.
TEST(MotionVolume, SaysWhereTheMeshOfTheBallEnds) {
  const BallSocketPair joint{cup(20.0, 60.0, 4000), cup(26.0, 20.0, 1000)};
  const MotionVolume volume(CellTest(joint), {.width = 0.1});
  const VolumeShares& found = volume.shares();
  const double share = 0.5 * (1.0 - std::cos(40.0 * kDegree));
  EXPECT_EQ(found.blocked, 0.0);
  EXPECT_LE(found.free, share + 1e-3);
  EXPECT_GE(found.free, share - 0.1);
  EXPECT_GE(found.unknown, 1.0 - share - 0.1);
  // Of the whole bone it is known that nothing touches.
  const MotionVolume whole(CellTest(joint, {}, {{}, {}, sphere(20.0, 1000), {}}), {.width = 0.1});
  EXPECT_NEAR(whole.shares().free, 1.0, 1e-9);
}

// The same in parts of cells: the tilt decides alone, and what is open is as thin as the square of a cell.
TEST(MotionVolume, PartsEndWhereTheMeshOfTheBallEnds) {
  const double end =
      40.0 * kDegree;  // of the tilt, where the border of the ball comes over that of the socket
  const CellTest test({cup(20.0, 60.0, 4000), cup(26.0, 20.0, 1000)});
  CellSearch search(test);
  test::Dice dice(77);
  std::size_t open = 0;
  std::size_t truly_free = 0;
  for (std::size_t round = 0; round < random_cases() / 10; ++round) {
    const double way = dice.between(0.0, 2.0 * kPi);
    const double tilt = end - dice.between(0.0, 0.05);
    const Vec3 axis(std::cos(way), std::sin(way), 0.0);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(tilt, axis) *
                                  Eigen::AngleAxisd(dice.between(-kPi, kPi), Vec3::UnitZ()));
    const RotationCell cell =
        cell_of({turn.w(), turn.x(), turn.y(), turn.z()}, static_cast<std::uint32_t>(dice.whole(5, 8)));
    const CellPart part = search.part_of(cell, {});
    for (int draw = 0; draw < 10; ++draw) {
      const Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      const double tilted = std::acos(rotation_of(point_of(cell, {t[0], t[1], t[2]}))(2, 2));
      const bool free = part.state == CellState::free || part.is_free(t);
      EXPECT_FALSE(free && tilted > end) << cell.level;
      if (tilted > end) continue;
      ++truly_free;
      if (!free) ++open;
    }
  }
  EXPECT_GT(truly_free, random_cases() / 10);
  EXPECT_LT(3 * open, truly_free);
}

TEST(MotionVolume, OfABlockedJointReachesNothing) {
  const BallSocketPair joint{sphere(30.0, 2000), cup(26.0, 80.0, 500)};
  const MotionVolume volume(CellTest(joint), {.width = 0.01});
  EXPECT_NEAR(volume.shares().blocked, 1.0, 1e-12);
  EXPECT_EQ(volume.shares().reachable_high, 0.0);
}

// A head and a liner of one radius, both closed: the corners of one mesh are a few hundredths of a millimetre
// beyond the faces of the other in every rotation, and no vertex is deep inside.
TEST(MotionVolume, OfAHeadAndALinerOfOneRadiusIsBlockedAtOnce) {
  const TriangleMesh inner = cup(20.0, 85.0, 3000);
  TriangleMesh back = inner;
  for (Vec3& x : back.vertices) x *= 1.4;
  const CellTest test({sphere(20.0, 8000), test::with_back(inner, back)});
  ASSERT_TRUE(test.bodies().has_inside());
  const MotionVolume volume(test, {.width = 0.001, .most_cells = 1000});
  EXPECT_NEAR(volume.shares().blocked, 1.0, 1e-12);
  EXPECT_LT(volume.shares().cells, 200U);
}

// Cells for every centre within 1 mm: with the meshes about centres that far off, none is wrong. Rotations
// are drawn from the cells, centres from the sphere of that radius and about the axis and across the contact,
// where they move the ball most.
void attack_centres(const BallSocketPair& joint, double gap_mm) {
  constexpr double kWithin = 1.0;
  const CellTest test(joint, {gap_mm, kWithin});
  const MotionVolume volume(test, {.width = 0.35});
  std::vector<VolumeCell> decided;
  volume.for_each([&](const VolumeCell& at) {
    if (at.state == CellState::free || at.state == CellState::blocked) decided.push_back(at);
  });
  std::ranges::stable_sort(decided, std::greater{}, [](const VolumeCell& at) { return at.cell.level; });
  std::mt19937_64 engine(6);
  std::normal_distribution<double> normal;
  std::array<std::size_t, 2> asked{};
  const std::size_t centres = 12;
  for (std::size_t k = 0; k < centres; ++k) {
    const Vec3 t = kWithin * Vec3(normal(engine), normal(engine), normal(engine)).normalized();
    const BallSocketPair moved{relative_to(joint.ball, t), relative_to(joint.socket, t)};
    test::ExactTouch overlay(moved);
    for (std::size_t round = 0; round < random_cases() / (2 * centres); ++round) {
      const std::size_t finest = std::min<std::size_t>(decided.size(), 20000);
      const VolumeCell& at = decided[std::uniform_int_distribution<std::size_t>(0, finest - 1)(engine)];
      std::array<double, 3> along{};
      for (double& x : along) x = std::clamp(normal(engine), -1.0, 1.0);
      const Pose pose{rotation_of(point_of(at.cell, along)), Vec3::Zero()};
      const auto least = overlay.vertices().least_gap(pose);
      const bool touches = overlay.impinged(pose) || (gap_mm > 0.0 && least && least->gap_mm <= gap_mm);
      EXPECT_EQ(touches, at.state == CellState::blocked) << at.cell.level << " " << at.cell.number;
      ++asked[touches ? 1 : 0];
    }
  }
  EXPECT_GT(asked[0], random_cases() / 80);
  EXPECT_GT(asked[1], random_cases() / 40);
}

TEST(TheoremVolume, HoldsForEveryCentre) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  attack_centres({hip.ball, hip.socket}, 0.0);
  attack_centres({hip.ball, hip.socket}, 2.0);
}

TEST(MotionVolume, OfAGapIsThatOfTheVertices) {
  const Hip hip = make_hip(hip_preset("normal"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  double before = 1.0;
  for (const double gap : {0.0, 1.0, 2.0}) {
    const MotionVolume volume(CellTest(joint, {gap, 0.0}), {.width = 0.15});
    const CulledJoint vertices(joint);
    test::Dice dice(15);
    for (std::size_t k = 0; k < random_cases(); ++k) {
      const Quaternion4 q = dice.quaternion();
      const VolumeCell at = volume.at(q);
      const auto least = vertices.least_gap({rotation_of(q), Vec3::Zero()});
      const bool touches = least && least->gap_mm <= gap;
      EXPECT_FALSE(at.state == CellState::free && touches);
      EXPECT_FALSE(at.state == CellState::blocked && gap > 0.0 && !touches);
    }
    EXPECT_LT(volume.shares().low(), before);
    before = volume.shares().high();
  }
}

TEST(MotionVolume, RefusesWhatHasNoAnswer) {
  const BallSocketPair joint{cup(20.0, 60.0, 500), cup(26.0, 20.0, 500)};
  EXPECT_THROW(CellTest(joint, {-1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(CellTest({TriangleMesh{}, joint.socket}), std::invalid_argument);
  EXPECT_THROW(MotionVolume(CellTest(joint), {.width = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
