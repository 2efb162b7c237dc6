// SPDX-License-Identifier: GPL-3.0-or-later
// Bone beside the joint stops it: limits of phantoms in closed form, and of hips by CGAL's exact
// intersection of all faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "limits/swept_parts.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/triangle_distance.hpp"
#include "reference/meeting_surfaces.hpp"
#include "rotations/volume.hpp"
#include "support/dice.hpp"
#include "support/exact_touch.hpp"
#include "support/hip_with_parts.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

const JointTurn kAboutZ{.axis = Vec3::UnitZ()};

// A sphere of a part: its middle lies in the plane z = 0.
struct Beside {
  double from_centre;  // mm
  double radius;       // mm
  double turned_deg;   // from +x
};

TriangleMesh mesh_of(const Beside& part, std::size_t halvings = 4) {
  const double turn = part.turned_deg * kDegree;
  return test::moved(icosphere(part.radius, halvings),
                     part.from_centre * Vec3(std::cos(turn), std::sin(turn), 0.0));
}

// A ball in a cup about +z, each with a part.
TurnLimits phantom(const Beside& of_ball, const Beside& of_socket) {
  return TurnLimits({icosphere(20.0, 2), cup(28.0, 60.0, 400)}, {{mesh_of(of_ball)}, {mesh_of(of_socket)}});
}

// A ball that ends is no bone beyond its end, and nothing that its opening could change is said of it: a part
// that goes by there, at the height of the ball's own, is not in contact. A sphere that the ball carries
// there is.
TEST(Parts, GoByWhereABallEnds) {
  constexpr double kEnd = 16.0;  // mm from the centre, of the ball's 20
  BallSocketPair main{icosphere(20.0, 4), cup(28.0, 30.0, 400)};
  std::erase_if(main.ball.faces, [&](const Face& face) {
    return std::ranges::any_of(face, [&](VertexIndex v) { return main.ball.vertices[v].x() > kEnd; });
  });
  const Beside socket{40.0, 3.0, 110.0};
  const TurnLimits limits(main, {{}, {mesh_of(socket)}});
  EXPECT_EQ(limits.first_contact(kAboutZ, 180.0).state, LimitState::free);
  for (int k = 0; k <= 180; ++k) EXPECT_EQ(limits.verdict(kAboutZ, k).contact, Contact::no) << k;
  const TurnLimits carries(main, {{mesh_of({40.0, 3.0, 0.0})}, {mesh_of(socket)}});
  EXPECT_EQ(carries.first_contact(kAboutZ, 180.0).state, LimitState::limited);
}

// Spheres whose middles are at a and b from the centre touch where these are the sum of the radii apart, and
// never where one is nearer to the centre by more than that, whatever directions they share.
TEST(Parts, OfSpheresMeetWhereTheyTouch) {
  const Beside socket{40.0, 8.0, 75.0};
  for (const Beside& ball : {Beside{40.0, 5.0, 0.0}, Beside{47.0, 6.0, 0.0}, Beside{50.0, 9.0, -20.0}}) {
    const TurnLimit limit = phantom(ball, socket).first_contact(kAboutZ, 180.0);
    ASSERT_EQ(limit.state, LimitState::limited);
    const double sum = ball.radius + socket.radius;
    const double a = ball.from_centre;
    const double b = socket.from_centre;
    const double apart = std::acos((a * a + b * b - sum * sum) / (2.0 * a * b)) / kDegree;
    EXPECT_NEAR(limit.low_deg, socket.turned_deg - ball.turned_deg - apart, 0.1);
    EXPECT_LT(limit.high_deg - limit.low_deg, 1e-6);
    EXPECT_EQ(limit.contact.value().body, (std::array<std::size_t, 2>{1, 1}));
  }
}

TEST(Parts, WithinOrBeyondOneAnotherPass) {
  const Beside socket{40.0, 8.0, 75.0};
  for (const Beside& ball : {Beside{26.0, 3.0, 0.0}, Beside{60.0, 9.0, -20.0}})
    EXPECT_EQ(phantom(ball, socket).first_contact(kAboutZ, 180.0).state, LimitState::free);
}

// A threshold is of the main surfaces alone: parts stop where they touch, whatever it is.
TEST(Parts, StopAtNoThreshold) {
  const Beside ball{40.0, 5.0, 0.0};
  const Beside socket{44.0, 8.0, 75.0};
  const TurnLimits limits = phantom(ball, socket);
  const TurnLimit contact = limits.first_contact(kAboutZ, 180.0);
  ASSERT_EQ(contact.state, LimitState::limited);
  for (const double gap : {0.1, 3.0, 5.0}) {
    const TurnLimit limit = limits.gap_of(kAboutZ, gap, 180.0);
    EXPECT_EQ(limit.state, LimitState::limited) << gap;
    EXPECT_EQ(limit.low_deg, contact.low_deg) << gap;
    EXPECT_EQ(limit.high_deg, contact.high_deg) << gap;
  }
  EXPECT_EQ(limits.gap_of(kAboutZ, 8.1, 180.0).state, LimitState::blocked) << "the gap of the joint";
}

// Does a part meet anything? By CGAL's exact intersection of all faces.
bool parts_meet(const BallSocketPair& main, const BoneParts& beside, const Eigen::Matrix3d& rotation) {
  const TriangleMesh ball = test::turned(main.ball, rotation);
  const auto meets = [](const TriangleMesh& mesh) {
    return [&mesh](const TriangleMesh& other) { return surfaces_meet(mesh, other); };
  };
  return std::ranges::any_of(beside.socket, meets(ball)) ||
         std::ranges::any_of(beside.ball, [&](const TriangleMesh& part) {
           const TriangleMesh moved = test::turned(part, rotation);
           return surfaces_meet(moved, main.socket) || std::ranges::any_of(beside.socket, meets(moved));
         });
}

// Of hips: before the limit no face meets another by CGAL, behind it some do. Where a part is what stops, the
// main surfaces alone go on.
TEST(Parts, OfHipsTouchWhereCgalSays) {
  const Hip hip = make_hip(test::hip_with_parts(), kFewestHipFaces);
  const BallSocketPair main = main_surfaces(hip);
  const BoneParts beside{part_surfaces(hip.ball, hip.ball_parts),
                         part_surfaces(hip.socket, hip.socket_parts)};
  const TurnLimits limits(main, beside);
  const TurnLimits without(main);
  const auto meet = [&](const JointTurn& turn, double degrees) {
    const Eigen::Matrix3d at =
        turn.outer * Eigen::AngleAxisd(degrees * kDegree, turn.axis).toRotationMatrix() * turn.inner;
    return parts_meet(main, beside, at) || surfaces_meet(test::turned(main.ball, at), main.socket);
  };
  std::size_t by_parts = 0;
  for (const MotionName& motion : motion_names()) {
    for (const Motion& start : {Motion{}, Motion{.flexion = 90.0}}) {
      const JointTurn turn = joint_turn(start, motion, Side::right);
      const double largest = std::min(largest_growth(start, motion), 180.0);
      if (!(largest > 0.0)) continue;
      const TurnLimit limit = limits.first_contact(turn, largest);
      const TurnLimit alone = without.first_contact(turn, largest);
      EXPECT_LE(limit.low_deg, alone.low_deg);
      for (double share : {0.2, 0.5, 0.8}) EXPECT_FALSE(meet(turn, share * limit.low_deg)) << motion.name;
      EXPECT_FALSE(meet(turn, std::max(0.0, limit.low_deg - 0.01))) << motion.name;
      if (limit.state != LimitState::limited) continue;
      EXPECT_TRUE(meet(turn, limit.high_deg + 0.01)) << motion.name;
      if (limit.contact->body == std::array<std::size_t, 2>{})
        EXPECT_EQ(limit.high_deg, alone.high_deg);
      else
        ++by_parts;
    }
  }
  EXPECT_GE(by_parts, 1U);
}

// Spheres of 20 mm, 50 mm from the centre: rotations that bring the directions of their middles within
// t = 2 asin((20 + gap / 2) / 50) of each other are blocked, a share of (1 - cos t) / 2. The meshes are
// within their spheres, by no more than their sagittas.
TEST(Parts, OfSpheresBlockAShareInClosedForm) {
  const BallSocketPair main{icosphere(10.0, 2), cup(20.0, 60.0, 400)};
  for (const double gap : {0.0, 6.0}) {
    const CellTest test(main, {.gap_mm = gap},
                        {{mesh_of({50.0, 20.0, 0.0}, 2)}, {mesh_of({50.0, 20.0, 75.0}, 2)}});
    const MotionVolume volume(test, {.width = 0.1});
    const auto turned = [&](double radius) { return 2.0 * std::asin((radius + 0.5 * gap) / 50.0); };
    const auto free = [&](double radius) { return 0.5 * (1.0 + std::cos(turned(radius))); };
    EXPECT_LE(volume.shares().open, 0.1);
    EXPECT_LE(volume.shares().low(), free(20.0 * 0.96));
    EXPECT_GE(volume.shares().high(), free(20.0));
    EXPECT_EQ(volume.shares().unknown, 0.0);
    EXPECT_EQ(volume.shares().reachable_low, volume.shares().free);
    const VolumeLimit limit = volume.limit(kAboutZ, 180.0);
    const double exact = 75.0 - turned(20.0) / kDegree;
    EXPECT_LE(limit.low_deg, exact + 2.0);
    EXPECT_GE(limit.high_deg.value(), exact);
    ASSERT_TRUE(limit.stops);
    EXPECT_EQ(limit.stops->hint.socket_face, CellHint::kNone) << "the main surfaces stop nothing";
  }
}

// Random rotations, asked of CGAL's exact intersection of all faces and, where the socket is a sheet, of the
// exact overlay.
TEST(Parts, OfAHipAreInItsVolume) {
  const Hip hip = make_hip(test::hip_with_parts(), 1000);
  const BallSocketPair main = main_surfaces(hip);
  BoneParts beside{part_surfaces(hip.ball, hip.ball_parts), part_surfaces(hip.socket, hip.socket_parts)};
  beside.ball.push_back(mesh_of({48.0, 15.0, 200.0}, 2));  // two that meet often
  beside.socket.push_back(mesh_of({50.0, 15.0, 20.0}, 2));
  const MotionVolume volume(CellTest(main, {}, beside), {.width = 0.2});
  const MotionVolume without(CellTest(main), {.width = 0.2});
  EXPECT_LT(volume.shares().low(), without.shares().low());
  test::ExactTouch overlay(main);
  test::Dice dice(5);
  std::size_t free = 0;
  std::size_t by_parts = 0;
  for (std::size_t k = 0; k < 2 * random_cases() && free + by_parts < 400; ++k) {
    const Quaternion4 q = dice.quaternion();
    const VolumeCell cell = volume.at(q);
    if (cell.state == CellState::open) continue;
    const bool joint = overlay.impinged({rotation_of(q), Vec3::Zero()});
    const bool stops = joint || parts_meet(main, beside, rotation_of(q));
    ASSERT_EQ(cell.state, stops ? CellState::blocked : CellState::free) << k;
    free += stops ? 0 : 1;
    by_parts += stops && !joint ? 1 : 0;
  }
  EXPECT_GT(free, 20U);
  EXPECT_GT(by_parts, 5U);
}

// Of a doubtful centre: what is found for a joint that is moved lies in what was said, also where the ball
// was scanned otherwise and turned about that centre.
TEST(Parts, OfHipsKeepWhatIsSaidOfTheCentre) {
  const auto sphere_at = [](double turned) { return mesh_of({40.0, 7.0, turned}); };
  const BallSocketPair main{icosphere(20.0, 2), cup(28.0, 60.0, 400)};
  const BoneParts beside{{sphere_at(0.0)}, {sphere_at(75.0)}};
  const TurnLimits limits(main, beside);
  for (const double scanned : {0.0, 90.0}) {
    JointTurn turn = kAboutZ;
    turn.rest = Eigen::AngleAxisd(scanned * kDegree, Vec3::UnitZ()).toRotationMatrix();
    const CentreQuestion question{CentreDoubt::common, 0.5, 0.0};
    const TurnLimit limit = limits.first_contact(turn, 180.0);
    const CentreInterval interval = limits.centre_interval(turn, limit, 180.0, question);
    const CellTest cells(main, {0.0, 0.5, 0.0, turn.rest}, beside);
    CellSearch search(cells);
    EXPECT_TRUE(interval.limited);
    double least = 180.0;
    double most = 0.0;
    for (int k = 0; k < 6; ++k) {
      const Vec3 t = 0.5 * Eigen::AngleAxisd(k * kPi / 3.0, Vec3::UnitZ()).toRotationMatrix() * Vec3::UnitX();
      const Vec3 of_ball = turn.rest * t;
      const TurnLimits moved({relative_to(main.ball, of_ball), relative_to(main.socket, t)},
                             {{relative_to(sphere_at(0.0), of_ball)}, {relative_to(sphere_at(75.0), t)}});
      const TurnLimit found = moved.first_contact(turn, 180.0);
      least = std::min(least, found.low_deg);
      most = std::max(most, found.high_deg);
    }
    EXPECT_LT(interval.low_deg, least);
    EXPECT_GT(interval.high_deg, most);
    EXPECT_LT(most - least, interval.high_deg - interval.low_deg);
    EXPECT_LT(interval.high_deg - interval.low_deg, 10.0);
    std::array<int, 4> states{};
    for (double angle = 45.0; angle < 65.0; angle += 0.25) {
      const Eigen::Matrix3d about = Eigen::AngleAxisd(angle * kDegree, Vec3::UnitZ()).toRotationMatrix();
      const CellState state = search.decide(RotationBall{about, 1e-6}).state;
      ++states[static_cast<std::size_t>(state)];
      EXPECT_TRUE(state != CellState::free || angle < least) << angle;
      EXPECT_TRUE(state != CellState::blocked || angle > most) << angle;
    }
    EXPECT_GT(states[0], 20) << scanned;
    EXPECT_GT(states[1], 20) << scanned;
  }
}

// No sampled angle before the one that is found has a pair of parts within the distance, by brute force, and
// that angle has one but for the steps of the search.

using test::Dice;

constexpr std::size_t kParts = 2;
constexpr int kSamples = 30;          // of each kind
constexpr double kSearchStep = 3e-5;  // radians, more than the last step of the search
constexpr double kWholeTurn = 2.0 * kPi;

struct Within {
  double start;   // mm
  double growth;  // mm a radian
  double operator()(const AngleSpan& span) const { return start + growth * span.to; }
};

struct SweptCase {
  std::vector<TurnFace> turning;
  std::vector<TurnFace> resting;
  Within within;
  double arm = 0.0;  // mm, of the farthest corner that turns
};

Vec3 random_way(Dice& random, double length) { return random.rotation() * Vec3(0, 0, length); }

// A point as often as a triangle.
TurnFace random_part(Dice& random, const Vec3& middle) {
  const double size = random.between(0.0, 1.0) < 0.5 ? 0.0 : random.power(-2.0, 1.0);
  const auto corner = [&] { return Vec3(middle + random_way(random, size)); };
  TurnFace face = turn_face(corner(), corner(), corner());
  face.doubt = random.between(0.0, 0.1);
  return face;
}

// Parts at rest are about the threshold from where one that turns comes by: all at nearly one angle, which
// may be that of the start, so that some come first by little and some at the end of the turn.
SweptCase random_case(Dice& random) {
  SweptCase made;
  made.within = {random.power(-2.0, 0.3), random.between(0.0, 0.2)};
  const double about = random.between(0.0, 1.0) < 0.5 ? random.between(0.0, kWholeTurn) : 0.0;
  for (std::size_t k = 0; k < kParts; ++k) {
    const double arm = random.power(-1.0, 1.5);
    const Vec3 middle = turned(Vec3(arm, 0, random.between(-20.0, 20.0)), random.between(0.0, kWholeTurn));
    made.turning.push_back(random_part(random, middle));
    for (const Vec3& x : made.turning.back().corner) made.arm = std::max(made.arm, x.head<2>().norm());
    const Vec3 off = random_way(random, made.within.start * random.between(0.5, 1.5));
    made.resting.push_back(random_part(random, turned(middle, about - random.power(-4.0, 0.0)) + off));
  }
  return made;
}

// How much nearer than asked for the nearest pair is, mm.
double surplus(const SweptCase& given, double angle) {
  double most = -HUGE_VAL;
  for (const TurnFace& s : given.turning) {
    const auto& [a, b, c] = s.corner;
    const Triangle moved{turned(a, angle), turned(b, angle), turned(c, angle)};
    for (const TurnFace& t : given.resting)
      most = std::max(most, s.doubt + t.doubt - std::sqrt(squared_distance_of_triangles(moved, t.corner)));
  }
  return most + given.within({angle, angle});
}

// Everywhere before the angle, and next to it.
void expect_nothing_before(const SweptCase& given, double angle, Dice& random) {
  for (int k = 0; k < kSamples; ++k) {
    for (const double t : {random.between(0.0, 1.0) * angle, angle - random.power(-6.0, 0.0)}) {
      if (t < 0.0 || t >= angle) continue;
      ASSERT_LE(surplus(given, t), 1e-9) << t << " before " << angle;
    }
  }
}

TEST(SweptParts, AreFirstWithinWhereBruteForceHasThem) {
  Dice random(21);
  std::size_t met = 0;
  const std::size_t cases = random_cases();
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    const SweptCase given = random_case(random);
    const double largest = std::min(random.between(0.0, 2.0 * kWholeTurn), kWholeTurn);
    const SweptParts turning(given.turning);
    const SweptParts resting(given.resting);
    const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
    const double first = first_within({turning, upright, resting, upright}, given.within, largest);
    expect_nothing_before(given, first, random);
    if (first == largest) continue;
    met += first > 0.0 ? 1 : 0;
    ASSERT_GE(surplus(given, first), -kSearchStep * (given.arm + given.within.growth)) << k;
  }
  EXPECT_GT(met, cases / 4);
}

// A triangle goes round a point on the axis, always 10 mm away from it, which the search cannot tell from a
// distance that is less by the way of its finest steps: it gives up early, on the safe side.
TEST(SweptParts, ThatStayNearlyAsNearForLongAreNotFollowedToTheEnd) {
  const SweptParts turning({turn_face({10, -3, 5}, {10, 3, 5}, {12, 0, 5})});
  const SweptParts resting({turn_point({0, 0, 5})});
  const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
  const SweptPair pair{turning, upright, resting, upright};
  const auto first = [&](double short_of) {
    return first_within(
        pair, [&](const AngleSpan&) { return 10.0 - short_of; }, kWholeTurn);
  };
  EXPECT_EQ(first(-1e-3), 0.0) << "they are as near all the time";
  EXPECT_EQ(first(0.1), kWholeTurn) << "they never are";
  const double given_up = first(12.0 * 2.5e-5);
  EXPECT_GT(given_up, 0.0);
  EXPECT_LT(given_up, kWholeTurn);
}

TEST(SweptParts, OfNothingAreNearNothing) {
  const SweptParts none;
  const SweptParts one({turn_point({1, 0, 0})});
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.any_node([](const SweptParts::Node&) { return true; }));
  EXPECT_TRUE(none.farther_than(1e9, Vec3::Zero()));
  EXPECT_FALSE(one.farther_than(1e9, Vec3::Zero()));
  const auto pair_is_asked = [](const SweptParts& a, const SweptParts& b) {
    const auto apart = [](std::uint32_t, std::uint32_t) { return false; };
    return any_pair(a, b, apart, [](std::uint32_t, std::uint32_t) { return true; });
  };
  const auto first_near = [](const SweptParts& a, const SweptParts& b) {
    const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
    return first_within(
        {a, upright, b, upright}, [](const AngleSpan&) { return 1e9; }, 1.0);
  };
  EXPECT_TRUE(pair_is_asked(one, one));
  EXPECT_EQ(first_near(one, one), 0.0);
  for (const auto& [a, b] : {std::pair(&none, &one), std::pair(&one, &none), std::pair(&none, &none)}) {
    EXPECT_FALSE(pair_is_asked(*a, *b));
    EXPECT_EQ(first_near(*a, *b), 1.0);
  }
}

}  // namespace
}  // namespace impinge
