// SPDX-License-Identifier: GPL-3.0-or-later
// With play a rotation is free with some shift of the ball, or blocked with every shift. A closed form says
// so, and random rotations with shifts: the exact overlay decides about them where radii count, CGAL's exact
// intersection of all faces where both bones have an inside.
#include "rotations/play.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "gap/overlay.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "reference/meeting_surfaces.hpp"
#include "rotations/volume.hpp"
#include "support/closed_bones.hpp"
#include "support/cone_neck.hpp"
#include "support/dice.hpp"
#include "support/exact_touch.hpp"
#include "support/grid_joint.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

Vec3 any_shift(test::Dice& dice) {
  const double length = std::cbrt(dice.between(0.0, 1.3));  // often the longest there is
  return std::min(1.0, length) * dice.direction();
}

double most_inside(std::span<const ShiftHalfSpace> all, const Vec3& shift) {
  double most = -HUGE_VAL;
  for (const ShiftHalfSpace& at : all) most = std::max(most, at.normal.dot(shift) - at.least);
  return most;
}

// The longest shifts too are kept to a step and no longer than the play, whichever way they are rounded.
TEST(ShiftSteps, AreNoLongerThanThePlay) {
  constexpr double kPlay = 0.7;
  test::Dice dice(72);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 shift = kPlay * any_shift(dice);
    const Vec3 kept = shift_of(steps_of(shift, kPlay), kPlay);
    EXPECT_LE(kept.norm(), kPlay);
    EXPECT_LE((kept - shift).cwiseAbs().maxCoeff(), 1.51 * kPlay / kShiftSteps);
  }
  for (const Vec3& along : {Vec3(0.6, 0.8, 0.0), Vec3(-0.6, 0.0, 0.8), Vec3(0.0, 0.0, -1.0)})
    EXPECT_LE(shift_of(steps_of(kPlay * along, kPlay), kPlay).norm(), kPlay);
}

// No shift is less far inside than is said; and the shift that is told is hardly farther, most often.
TEST(TheoremPlay, HalfSpacesHoldAllShifts) {
  constexpr double kPlay = 2.0;
  constexpr double kShort = 0.05;  // mm
  test::Dice dice(71);
  std::size_t held = 0;
  std::size_t missed = 0;
  const std::size_t sets = random_cases() / 10;
  for (std::size_t k = 0; k < sets; ++k) {
    std::vector<ShiftHalfSpace> all(static_cast<std::size_t>(dice.whole(1, 12)));
    const Vec3 towards = dice.direction();
    for (ShiftHalfSpace& at : all)
      at = {(dice.direction() + dice.between(0.0, 3.0) * towards).normalized(), dice.between(-2.5, 0.5)};
    const FarthestShift found = farthest_from(all, kPlay);
    EXPECT_LE(found.shift.norm(), kPlay);
    if (most_inside(all, found.shift) > found.inside + kShort) ++missed;
    if (found.inside > 0.0) ++held;
    for (std::size_t l = 0; l < 200; ++l)
      EXPECT_GE(most_inside(all, kPlay * any_shift(dice)), found.inside - 1e-12);
  }
  EXPECT_LE(missed, sets / 10);
  EXPECT_GT(held, sets / 10);
  EXPECT_LT(held, sets);
}

// Is there contact in a rotation with a shift of the ball, mm? Exact.
using Touches = std::function<bool(const Eigen::Matrix3d& rotation, const Vec3& shift)>;

struct Attacked {
  std::size_t free = 0;
  std::size_t shifted = 0;  // free with a shift
  std::size_t blocked = 0;
  std::size_t unknown = 0;
};

// Asks about rotations of random cells that are decided. In what is free none may touch with the cell's
// shift; in a blocked cell each must touch with any shift. If the ball's mesh ends, it does so over no free
// one, and over each unknown one.
class ShiftAttack {
 public:
  ShiftAttack(const CellTest& test, Touches touches, Touches ends = nullptr)
      : play_(test.question().play_mm), touches_(std::move(touches)), ends_(std::move(ends)), search_(test) {}

  // Asks about one cell alone.
  void ask(const RotationCell& cell) { ask(cell, search_.decide(cell)); }

  const Attacked& asked() const { return asked_; }

  Attacked run(std::size_t cells) {
    for (std::size_t k = 0; k < cells; ++k) {
      const RotationCell finest = cell_of(dice_.quaternion(), kFinestCells);
      CellVerdict verdict;
      // From coarse to fine, as a refinement would: the first that is decided.
      for (std::uint32_t level = 2; level <= 9 && verdict.state == CellState::open; ++level) {
        const RotationCell cell{level, finest.number >> (3 * (kFinestCells - level))};
        verdict = search_.decide(cell, verdict.hint);
        ask(cell, verdict);
      }
    }
    return asked_;
  }

 private:
  void ask(const RotationCell& cell, const CellVerdict& verdict) {
    const Vec3 shift = shift_of(verdict.hint, play_);
    EXPECT_LE(shift.norm(), play_);
    for (std::size_t k = 0; k < 5; ++k) {
      Vec3 t;
      for (double& x : t) x = std::clamp(dice_.between(-1.3, 1.3), -1.0, 1.0);  // borders too
      const Eigen::Matrix3d rotation = rotation_of(point_of(cell, {t[0], t[1], t[2]}));
      if (verdict.state == CellState::blocked) {
        ++asked_.blocked;
        EXPECT_TRUE(touches_(rotation, play_ * any_shift(dice_))) << cell.level << " " << cell.number;
      } else if (verdict.state == CellState::free) {
        ++(shift.isZero(0.0) ? asked_.free : asked_.shifted);
        EXPECT_FALSE(touches_(rotation, shift)) << cell.level << " " << cell.number;
      }
      const bool nothing = verdict.state == CellState::free || verdict.state == CellState::unknown;
      if (ends_ && nothing) {
        EXPECT_EQ(ends_(rotation, shift), verdict.state == CellState::unknown) << cell.level;
        if (verdict.state == CellState::unknown) ++asked_.unknown;
      }
    }
  }

  double play_;
  Touches touches_;
  Touches ends_;
  CellSearch search_;
  test::Dice dice_{72};
  Attacked asked_;
};

// Of a sheet: seen from either centre; a gap from that of the ball.
Attacked attack_shifts_by_radii(double gap_mm, double play_mm, std::size_t cells) {
  const Hip hip = make_hip(hip_preset("cam"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  test::ExactTouch overlay(joint);
  const auto touches = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
    if (overlay.impinged({rotation, shift})) return true;
    if (gap_mm == 0.0) return false;
    const BallSocketPair moved{joint.ball, relative_to(joint.socket, shift)};
    const auto least = CulledJoint(moved).least_gap({rotation, Vec3::Zero()});
    return least && least->gap_mm <= gap_mm;
  };
  return ShiftAttack(CellTest(joint, {.gap_mm = gap_mm, .play_mm = play_mm}), touches).run(cells);
}

TEST(TheoremPlay, IsNeverWrongOfAHip) {
  const Attacked asked = attack_shifts_by_radii(0.0, 1.5, random_cases());
  EXPECT_GT(asked.free, random_cases() / 10);
  EXPECT_GT(asked.shifted, random_cases() / 10);
  EXPECT_GT(asked.blocked, random_cases());
}

TEST(TheoremPlay, IsNeverWrongOfAGap) {
  const Attacked asked = attack_shifts_by_radii(1.0, 1.5, random_cases() / 4);
  EXPECT_GT(asked.shifted, random_cases() / 40);
  EXPECT_GT(asked.blocked, random_cases() / 4);
}

// A small play leaves cells blocked, a larger one has free cells that need a shift.
TEST(TheoremPlay, IsNeverWrongOfBonesWithAnInside) {
  const test::ClosedBones bones;
  const auto touches = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
    return bones.meet(rotation, shift);
  };
  for (const double play : {0.5, 2.0}) {
    const CellTest test(bones.joint, {.play_mm = play});
    ASSERT_TRUE(test.bodies().has_inside());
    const Attacked asked = ShiftAttack(test, touches).run(random_cases() / 4);
    EXPECT_GT(asked.free, 0U) << play;
    if (play < 1.0) {
      EXPECT_GT(asked.blocked, random_cases() / 10);
    } else {
      EXPECT_GT(asked.shifted, random_cases() / 40);
    }
  }
}

// Where the wings come near the head's surface does not.
TEST(TheoremPlay, IsNeverWrongOfPartsBesideTheBones) {
  const test::ClosedBones bones({27.0, 20.0, 0.0});
  const CellTest test({bones.head, bones.joint.socket}, {.play_mm = 1.0}, {bones.wings, {}});
  const auto touches = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
    return bones.meet(rotation, shift);
  };
  const Attacked asked = ShiftAttack(test, touches).run(random_cases() / 4);
  EXPECT_GT(asked.free, 0U);
  EXPECT_GT(asked.shifted, 0U);
  EXPECT_GT(asked.blocked, random_cases() / 40);
}

// A closed prism on a triangle, 5 mm deep.
TriangleMesh prism(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 down(0.0, 0.0, -5.0);
  TriangleMesh mesh;
  mesh.vertices = {a, b, c, a + down, b + down, c + down};
  mesh.faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
  return mesh;
}

// In the middle of a cell the tops of two prisms lie in one plane, 0.1 mm apart: their normals do not tell
// them apart, nor does the line between their middles.
TEST(TheoremPlay, IsNeverWrongOfFacesInOnePlane) {
  const TriangleMesh inner = cup(300.0, 60.0, 100);
  TriangleMesh outer = inner;
  for (Vec3& x : outer.vertices) x *= 1.1;
  const BallSocketPair joint{icosphere(5.0, 1), test::with_back(inner, outer)};
  const TriangleMesh moving = prism({40.0, 0.0, 5.0}, {50.0, 0.0, 5.0}, {40.0, 1.0, 5.0});
  const TriangleMesh still = prism({40.0, 1.1, 5.0}, {50.0, 0.1, 5.0}, {50.0, 1.1, 5.0});
  test::Dice dice(77);
  Attacked all;
  for (std::size_t k = 0; k < random_cases() / 25; ++k) {
    const RotationCell cell = cell_of(dice.quaternion(), static_cast<std::uint32_t>(dice.whole(5, 11)));
    const TriangleMesh ball = test::turned(moving, rotation_of(centre(cell)).transpose());
    const CellTest test(joint, {.play_mm = dice.between(0.01, 1.0)}, {{ball}, {still}});
    const auto touches = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
      return surfaces_meet(test::moved(test::turned(ball, rotation), shift), still);
    };
    ShiftAttack attack(test, touches);
    attack.ask(cell);
    all.free += attack.asked().free;
    all.shifted += attack.asked().shifted;
    EXPECT_EQ(attack.asked().blocked, 0U);
  }
  EXPECT_GT(all.free, 0U);
  EXPECT_GT(all.shifted, 0U);
}

// A part of the socket round the centre: a part of the ball with a corner there stays in it with every shift.
TEST(TheoremPlay, BlocksAllWhereAPartHoldsTheCentre) {
  const test::ClosedBones bones;
  TriangleMesh speck;
  test::add_face(speck, Vec3::Zero(), {0.1, 0.0, 0.0}, {0.0, 0.1, 0.1});
  const CellTest test({bones.head, bones.joint.socket}, {.play_mm = 1.0}, {{speck}, {icosphere(4.0, 1)}});
  CellSearch search(test);
  test::Dice dice(78);
  for (int k = 0; k < 50; ++k)
    EXPECT_EQ(search.decide(cell_of(dice.quaternion(), static_cast<std::uint32_t>(dice.whole(2, 9)))).state,
              CellState::blocked);
}

// Faces whose plane holds a centre; and shifts with which it holds the other.
TEST(TheoremPlay, IsNeverWrongOfEdgeOnFaces) {
  test::Dice dice(73);
  Attacked all;
  for (std::size_t k = 0; k < random_cases() / 25; ++k) {
    const BallSocketPair joint = test::grid_joint(dice);
    const SurfaceOverlay radii(joint.ball, joint.socket);
    const CellTest test(joint, {.play_mm = 0.5});
    const auto touches = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
      return radii.impinged({rotation, shift}) ||
             surfaces_meet(test::moved(test::turned(joint.ball, rotation), shift), joint.socket);
    };
    const Attacked asked = ShiftAttack(test, touches).run(25);
    all.free += asked.free;
    all.shifted += asked.shifted;
    all.blocked += asked.blocked;
  }
  EXPECT_GT(all.free, random_cases());
  EXPECT_GT(all.shifted, random_cases() / 100);
  EXPECT_GT(all.blocked, random_cases() / 100);
}

// A ball with a hole under a cup. Random points of the cup, and directions of the hole, say whether the hole
// is under it.
Attacked attack_shifts_of_a_hole(BallSocketPair joint, double play_mm) {
  const Vec3 middle = Vec3(0.3, -0.4, 0.7).normalized();
  std::vector<Vec3> in_hole;  // its corners, and some others
  for (const Vec3& x : joint.ball.vertices)
    if (angle_between(x, middle) < 0.35) in_hole.push_back((x.normalized() + 1e-4 * middle).normalized());
  std::erase_if(joint.ball.faces, [&](const Face& face) {
    const auto corners = corners_of(joint.ball, face);
    return angle_between(corners[0] + corners[1] + corners[2], middle) < 0.25;
  });
  test::ExactTouch overlay(joint);
  const RayCaster ball(joint.ball);
  test::Dice dice(75);
  const auto ends = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
    const auto misses = [&](const Vec3& y) {
      return std::isnan(ball.cast((rotation.transpose() * (y - shift)).normalized(), Layer::farthest));
    };
    if (std::ranges::any_of(joint.socket.vertices, misses)) return true;
    for (std::size_t k = 0; k < 1000; ++k) {
      const auto face =
          static_cast<std::size_t>(dice.whole(0, static_cast<int>(joint.socket.faces.size()) - 1));
      const auto corners = corners_of(joint.socket, joint.socket.faces[face]);
      const double a = dice.between(0.0, 1.0);
      const double b = (1.0 - a) * dice.between(0.0, 1.0);
      if (misses(a * corners[0] + b * corners[1] + (1.0 - a - b) * corners[2])) return true;
    }
    const RayCaster socket(relative_to(joint.socket, shift));
    const auto is_bare = [&](const Vec3& u) {
      return std::isnan(ball.cast(u, Layer::farthest)) &&
             !std::isnan(socket.cast(rotation * u, Layer::nearest));
    };
    if (std::ranges::any_of(in_hole, is_bare)) return true;
    for (std::size_t k = 0; k < 1000; ++k)
      if (is_bare((middle + 0.2 * dice.vector()).normalized())) return true;
    return false;
  };
  const auto touches = [&](const Eigen::Matrix3d& rotation, const Vec3& shift) {
    return overlay.impinged({rotation, shift});
  };
  return ShiftAttack(CellTest(joint, {.play_mm = play_mm}), touches, ends).run(random_cases() / 10);
}

// The ball meets the cup without a shift.
TEST(TheoremPlay, IsNeverWrongWhereTheBallEnds) {
  const Attacked asked =
      attack_shifts_of_a_hole({sphere(20.0, 1000), test::moved(cup(20.3, 60.0, 300), {0.0, 0.0, -0.4})}, 1.0);
  EXPECT_GT(asked.shifted, random_cases() / 20);
  EXPECT_GT(asked.unknown, random_cases() / 100);
}

TEST(TheoremPlay, IsNeverWrongOfABallSmallerThanItsPlay) {
  const Attacked asked = attack_shifts_of_a_hole({sphere(0.3, 1000), cup(25.0, 60.0, 300)}, 0.5);
  EXPECT_GT(asked.free, random_cases() / 100);
  EXPECT_GT(asked.unknown, random_cases() / 100);
  EXPECT_EQ(asked.blocked, 0U);
}

// Seen from the ball's centre a shift by r turns the rim of the cup, 26 mm away, by asin(r / 26) at most;
// seen from the socket's it turns the rim of the neck, 60 mm away, by asin(r / 60). Radii count as both see
// them, so that the neck may tilt by so much more than without play. The rims are polygons, within sagittas
// of circles.
struct ConeNeck {
  static constexpr double kPlay = 3.0;
  static constexpr double kNeck = 20.0 * kDegree;
  static constexpr double kOpening = 80.0 * kDegree;
  explicit ConeNeck(double sides)
      : joint(test::cone_neck(kNeck, kOpening, static_cast<std::size_t>(sides))),
        flat(std::cos(kPi / sides)) {}
  double least_tilt(double play) const {
    return std::atan(std::tan(kOpening) * flat) - kNeck + std::asin(play / 60.0);
  }
  double most_tilt(double play) const {
    return std::atan(std::tan(kOpening) / flat) - std::atan(std::tan(kNeck) * flat) +
           std::asin(play / (60.0 * flat));
  }
  BallSocketPair joint;
  double flat;
};

TEST(TheoremPlay, OfAConeNeckIsItsClosedForm) {
  const ConeNeck neck(60);
  const CellTest test(neck.joint, {.play_mm = ConeNeck::kPlay});
  CellSearch search(test);
  test::Dice dice(74);
  std::size_t decided = 0;
  const std::size_t tilts = random_cases() / 10;
  for (std::size_t k = 0; k < tilts; ++k) {
    const bool free = k % 2 == 0;
    const double tilt = free ? neck.least_tilt(ConeNeck::kPlay) - dice.between(0.3, 2.5) * kDegree
                             : neck.most_tilt(ConeNeck::kPlay) + dice.between(0.6, 3.0) * kDegree;
    const double azimuth = dice.between(-kPi, kPi);
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(tilt, Vec3(-std::sin(azimuth), std::cos(azimuth), 0.0)) *
        Eigen::AngleAxisd(dice.between(-kPi, kPi), Vec3::UnitZ()).toRotationMatrix();
    const CellVerdict found = search.decide(RotationBall{rotation, 1e-3});
    EXPECT_NE(found.state, free ? CellState::blocked : CellState::free) << tilt / kDegree;
    if (found.state != CellState::open) ++decided;
    const Pose pose{rotation, shift_of(found.hint, ConeNeck::kPlay)};
    if (found.state == CellState::free) {
      EXPECT_EQ(test.bodies().verdict(pose).contact, Contact::no) << tilt / kDegree;
    }
  }
  EXPECT_GT(decided, tilts * 9 / 10);
}

TEST(MotionVolume, WithPlayIsThatOfAConeNeckInClosedForm) {
  const ConeNeck neck(30);
  constexpr double kWidth = 0.1;
  const MotionVolume volume(CellTest(neck.joint, {.play_mm = ConeNeck::kPlay}), {.width = kWidth});
  const VolumeShares& found = volume.shares();
  const auto share_of = [](double tilt) { return 0.5 * (1.0 - std::cos(tilt)); };
  EXPECT_LE(found.open, kWidth);
  EXPECT_LE(found.low(), share_of(neck.most_tilt(ConeNeck::kPlay)));
  EXPECT_GE(found.high(), share_of(neck.least_tilt(ConeNeck::kPlay)));
  EXPECT_LE(found.reached(), share_of(neck.most_tilt(0.0)));
  std::size_t shifted = 0;
  volume.for_each([&](const VolumeCell& at) {
    if (at.state == CellState::free && at.hint.shift != CellHint{}.shift) ++shifted;
  });
  EXPECT_GT(shifted, 0U);
}

// The cells are the same with any number of threads and any verdicts known before.
TEST(MotionVolume, WithPlayIsTheSameAgain) {
  const Hip hip = make_hip(hip_preset("normal"), 1000);
  const BallSocketPair joint{hip.ball, hip.socket};
  using Cells = std::vector<std::pair<RotationCell, CellHint>>;
  std::vector<CellVerdict> reached;
  const auto cells = [&](const CellTest& test, std::size_t threads, std::span<const CellVerdict> known) {
    reached.clear();
    VolumeSettings settings = {.width = 0.3, .threads = threads, .known = known};
    settings.reached = [&](std::span<const CellVerdict> batch, double) {
      reached.insert(reached.end(), batch.begin(), batch.end());
    };
    Cells found;
    MotionVolume(test, settings).for_each([&](const VolumeCell& at) {
      found.emplace_back(at.cell, at.hint);
    });
    return found;
  };
  const CellTest test(joint, {.play_mm = 2.0});
  const Cells once = cells(test, 1, {});
  EXPECT_TRUE(std::ranges::any_of(once, [](const auto& at) { return at.second.shift != CellHint{}.shift; }));
  EXPECT_EQ(cells(test, 3, {}), once);
  const std::vector<CellVerdict> known(reached.begin(),
                                       reached.begin() + static_cast<long>(reached.size() / 3));
  EXPECT_EQ(cells(test, 2, known), once);
}

TEST(CellTest, RefusesPlayThatTakesTheBallOutOfTheSocket) {
  const BallSocketPair joint = test::cone_neck(0.3, 1.4, 20);
  EXPECT_THROW(CellTest(joint, {.play_mm = 26.0}), std::invalid_argument);
  EXPECT_THROW(CellTest(joint, {.gap_mm = 20.0, .play_mm = 6.0}), std::invalid_argument);
  EXPECT_THROW(CellTest(joint, {.play_mm = -1.0}), std::invalid_argument);
  EXPECT_THROW(CellTest(joint, {.centre_within_mm = 1.0, .play_mm = 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
