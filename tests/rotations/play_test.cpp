// SPDX-License-Identifier: GPL-3.0-or-later
// With play a rotation is free with some shift of the ball, or blocked with every shift. A closed form says
// so, and random rotations with shifts: the exact overlay decides about them where radii count, CGAL's exact
// intersection of all faces where both bones have an inside.
#include "rotations/play.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "rotations/volume.hpp"
#include "support/closed_bones.hpp"
#include "support/cone_neck.hpp"
#include "support/dice.hpp"
#include "support/exact_touch.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

Vec3 any_shift(test::Dice& dice) {
  const double length = std::cbrt(dice.between(0.0, 1.3));  // often the longest there is
  return std::min(1.0, length) * dice.direction();
}

TEST(TheoremPlay, BallsHoldAllShifts) {
  test::Dice dice(71);
  for (std::size_t place = 0; place < kShiftBalls; ++place)
    EXPECT_LE(shift_ball(place).middle.norm(), 1.0) << place;
  for (std::size_t k = 0; k < 20 * random_cases(); ++k) {
    const Vec3 d = any_shift(dice);
    std::size_t place = 1;
    while (place < kShiftBalls && (d - shift_ball(place).middle).norm() > shift_ball(place).radius) ++place;
    EXPECT_LT(place, kShiftBalls) << d.transpose();
  }
}

// touches(shift) makes the exact test of rotations for a shift of the ball, mm.
using Touches = std::function<bool(const Eigen::Matrix3d& rotation)>;
using TouchesWith = std::function<Touches(const Vec3& shift)>;

struct Attacked {
  std::size_t free = 0;
  std::size_t shifted = 0;  // free with a shift
  std::size_t blocked = 0;
};

// Asks about rotations of cells near the border. In a free cell none may touch with the cell's shift; in a
// blocked cell each must touch with any shift.
Attacked attack_shifts(const PlayTests& tests, std::size_t most_cells, std::size_t shifts,
                       const TouchesWith& touches_with) {
  const MotionVolume volume(tests, {.width = 0.12, .most_cells = most_cells});
  std::vector<VolumeCell> blocked;
  std::array<std::vector<VolumeCell>, kShiftBalls> free;
  volume.for_each([&](const VolumeCell& at) {
    EXPECT_EQ(at.shift.has_value(), at.state == CellState::free);
    if (at.state == CellState::blocked) blocked.push_back(at);
    if (at.state == CellState::free) free[at.hint.place].push_back(at);
  });
  std::ranges::stable_sort(blocked, std::greater{}, [](const VolumeCell& at) { return at.cell.level; });
  blocked.resize(std::min<std::size_t>(blocked.size(), 20000));
  test::Dice dice(72);
  Attacked asked;
  const auto ask = [&](const std::vector<VolumeCell>& cells, const Touches& touches, std::size_t& count) {
    for (std::size_t k = 0; k < random_cases() / shifts && !cells.empty(); ++k) {
      const VolumeCell& at =
          cells[static_cast<std::size_t>(dice.whole(0, static_cast<int>(cells.size()) - 1))];
      std::array<double, 3> along{};
      for (double& x : along) x = std::clamp(dice.between(-1.3, 1.3), -1.0, 1.0);  // borders too
      ++count;
      EXPECT_EQ(touches(rotation_of(point_of(at.cell, along))), at.state == CellState::blocked)
          << at.cell.level << " " << at.cell.number << " " << static_cast<int>(at.hint.place);
    }
  };
  for (std::size_t place = 0; place < kShiftBalls; ++place) {
    if (free[place].empty()) continue;
    EXPECT_LE(tests.shift(place).norm(), tests.play_mm());
    ask(free[place], touches_with(tests.shift(place)), place == 0 ? asked.free : asked.shifted);
  }
  for (std::size_t k = 0; k < shifts; ++k)
    ask(blocked, touches_with(tests.play_mm() * any_shift(dice)), asked.blocked);
  return asked;
}

void attack_shifts_by_radii(double gap_mm) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  const PlayTests tests(joint, {.gap_mm = gap_mm, .play_mm = 2.0});
  const auto touches_with = [&](const Vec3& shift) -> Touches {
    auto moved =
        std::make_shared<BallSocketPair>(BallSocketPair{joint.ball, relative_to(joint.socket, shift)});
    auto overlay = std::make_shared<test::ExactTouch>(*moved);
    return [moved, overlay, gap_mm](const Eigen::Matrix3d& rotation) {
      const Pose pose{rotation, Vec3::Zero()};
      const auto least = overlay->vertices().least_gap(pose);
      return overlay->impinged(pose) || (gap_mm > 0.0 && least && least->gap_mm <= gap_mm);
    };
  };
  const Attacked asked = attack_shifts(tests, 200000, 20, touches_with);
  EXPECT_GT(asked.free, random_cases() / 40);
  EXPECT_GT(asked.shifted, random_cases() / 10);
  EXPECT_GT(asked.blocked, random_cases() / 2);
}

TEST(TheoremPlay, IsNeverWrongOfAHip) { attack_shifts_by_radii(0.0); }
TEST(TheoremPlay, IsNeverWrongOfAGap) { attack_shifts_by_radii(1.0); }

TEST(TheoremPlay, IsNeverWrongOfBonesWithAnInside) {
  const test::ClosedBones bones;
  const PlayTests tests(bones.joint, {.play_mm = 2.0});
  ASSERT_TRUE(tests.test(0).bodies().has_inside());
  const auto touches_with = [&](const Vec3& shift) -> Touches {
    return [&bones, shift](const Eigen::Matrix3d& rotation) { return bones.meet(rotation, shift); };
  };
  const Attacked asked = attack_shifts(tests, 20000, 50, touches_with);
  EXPECT_GT(asked.free, random_cases() / 100);
  EXPECT_GT(asked.shifted, random_cases() / 20);
  EXPECT_GT(asked.blocked, random_cases() / 2);
}

// A shift by r turns the direction from the centre to the rim, 26 mm away, by asin(r / 26) at most. So much
// more tilt is free with play than without.
TEST(MotionVolume, WithPlayIsThatOfAConeNeckInClosedForm) {
  const double neck = 20.0 * kDegree;
  const double opening = 80.0 * kDegree;
  constexpr double kPlay = 3.0;
  constexpr double kSides = 30;
  const BallSocketPair joint = test::cone_neck(neck, opening, static_cast<std::size_t>(kSides));
  const MotionVolume volume(PlayTests(joint, {.play_mm = kPlay}), {.width = 0.08});
  const VolumeShares& found = volume.shares();
  const auto share_of = [](double tilt) { return 0.5 * (1.0 - std::cos(tilt)); };
  const double flat = std::cos(kPi / kSides);
  const double narrow = std::atan(std::tan(neck) * flat);
  const double wide = std::atan(std::tan(opening) / flat);
  EXPECT_LE(found.open, 0.08);
  EXPECT_LE(found.low(), share_of(wide - narrow + std::asin(kPlay / (26.0 * flat))));
  EXPECT_GE(found.high(), share_of(std::atan(std::tan(opening) * flat) - neck + std::asin(kPlay / 26.0)));
  EXPECT_GT(found.low(), share_of(wide - narrow));
  EXPECT_LE(found.reached(), share_of(wide - narrow));
}

// The cells are the same with any number of threads and any verdicts known before. A play of 0 gives the
// cells of a test without play.
TEST(MotionVolume, WithPlayIsTheSameAgain) {
  const Hip hip = make_hip(hip_preset("normal"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  using Cells = std::vector<std::pair<RotationCell, CellHint>>;
  std::vector<CellVerdict> reached;
  const auto cells = [&](const PlayTests& tests, std::size_t threads, std::span<const CellVerdict> known) {
    reached.clear();
    VolumeSettings settings = {.width = 0.15, .threads = threads, .known = known};
    settings.reached = [&](std::span<const CellVerdict> batch, double) {
      reached.insert(reached.end(), batch.begin(), batch.end());
    };
    Cells found;
    MotionVolume(tests, settings).for_each([&](const VolumeCell& at) {
      found.emplace_back(at.cell, at.hint);
    });
    return found;
  };
  const CellQuestion question{.play_mm = 2.0};
  const Cells once = cells(PlayTests(joint, question), 1, {});
  EXPECT_TRUE(std::ranges::any_of(once, [](const auto& at) { return at.second.place != 0; }));
  EXPECT_EQ(cells(PlayTests(joint, question), 3, {}), once);
  const std::vector<CellVerdict> known(reached.begin(),
                                       reached.begin() + static_cast<long>(reached.size() / 3));
  EXPECT_EQ(cells(PlayTests(joint, question), 2, known), once);
  const CellTest without(joint);
  EXPECT_EQ(cells(PlayTests(joint, {}), 2, {}), cells(PlayTests(without), 2, {}));
}

TEST(PlayTests, RefuseWhatTakesTheBallOutOfTheSocket) {
  const BallSocketPair joint = test::cone_neck(0.3, 1.4, 20);
  EXPECT_THROW(PlayTests(joint, {.play_mm = 26.0}), std::invalid_argument);
  EXPECT_THROW(PlayTests(joint, {.play_mm = -1.0}).test(0), std::invalid_argument);
  EXPECT_THROW(PlayTests(joint, {.centre_within_mm = 1.0, .play_mm = 1.0}).test(0), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
