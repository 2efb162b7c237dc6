// SPDX-License-Identifier: GPL-3.0-or-later
// The angle that is returned is the first at which the surfaces meet: by CGAL's exact intersection of all
// faces they do not before, in steps of a hundredth of a degree next to it and larger ones elsewhere, and do
// beyond.
#include "limits/turn_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "change/resection.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/meeting_surfaces.hpp"
#include "support/directions.hpp"
#include "support/every_vertex.hpp"
#include "support/poses.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

constexpr double kStep = 0.01 * kDegree;
constexpr double kFarthest = 2.0;  // radians
constexpr int kSteps = 15;         // of each kind
constexpr double kBeyond = 1e-6;   // radians past a contact, where it is deep enough to be seen in doubles

struct Scene {
  std::string name;
  BallSocketPair joint;
};

// A head on a stick: edges, vertices and the rim come into play.
TriangleMesh head_with_neck(std::size_t faces) {
  return radial_body(faces, [](const Vec3& u) {
    const double neck = u.z() < 0.0 ? 12.0 / std::max(std::hypot(u.x(), u.y()), 1e-9) : 0.0;
    return std::max(22.0, std::min(neck, 50.0));
  });
}

// The faces with some corner above a height: a surface that ends.
TriangleMesh cut_above(TriangleMesh mesh, double height) {
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::ranges::none_of(face, [&](VertexIndex v) { return mesh.vertices[v].z() > height; });
  });
  return mesh;
}

std::vector<Scene> scenes() {
  PairShape off_centre = impinging_cam();
  off_centre.cam_azimuth_deg = 20.0;
  const TriangleMesh socket = cup(26.0, 80.0, 60);
  return {{"cam", make_ball_socket_pair(80, off_centre)},
          {"neck", {head_with_neck(100), socket}},
          {"neck that ends", {cut_above(head_with_neck(100), -20.0), socket}},
          {"octahedra", {octahedron(16.0), cut_above(octahedron(26.0), 0.5)}}};
}

struct Turning {
  Turning(const BallSocketPair& of, const Vec3& axis) : joint(of), turn{.axis = axis} {}
  const BallSocketPair& joint;
  JointTurn turn;
  TurnBody ball{joint.ball};
  TurnBody socket{joint.socket};

  auto first(const AngleSpan& angles) const { return first_contact({ball, socket, turn}, angles); }
  auto gap(double gap_mm, const AngleSpan& angles) const {
    return first_gap(ball.faces, socket.faces, turn, TurnGap(joint, gap_mm), angles);
  }
  Pose at(double angle) const {
    return {Eigen::AngleAxisd(angle, turn.axis).toRotationMatrix(), Vec3::Zero()};
  }
  bool meets(double angle) const {
    return surfaces_meet(test::turned(joint.ball, at(angle).rotation), joint.socket);
  }
};

// Angles before the limit, close by and everywhere.
std::vector<double> angles_before(double limit) {
  std::vector<double> angles{limit - kBeyond};
  for (int k = 0; k < kSteps; ++k) {
    angles.push_back(limit * k / kSteps);
    angles.push_back(limit - (k + 0.5) * kStep);
  }
  std::erase_if(angles, [](double angle) { return angle < 0.0; });
  return angles;
}

TEST(TheoremTurn, IsTheFirstThatCgalSees) {
  std::set<ContactKind> kinds;
  for (const Scene& scene : scenes()) {
    for (const Vec3& axis : test::random_directions(3, 3)) {
      const Turning turning{scene.joint, axis};
      const auto first = turning.first({0.0, kFarthest});
      const double limit = first ? first->angle : kFarthest;
      for (const double angle : angles_before(limit))
        ASSERT_FALSE(turning.meets(angle)) << scene.name << " " << angle << " of " << limit;
      if (!first) continue;
      kinds.insert(first->kind);
      EXPECT_TRUE(turning.meets(limit + kBeyond)) << scene.name << " " << name(first->kind);
    }
  }
  EXPECT_TRUE(kinds.contains(ContactKind::edges));
  EXPECT_GT(kinds.size(), 1U);
}

// The same for the gaps of vertices: none is at the threshold before, some is at the angle.
TEST(TheoremTurn, TheFirstGapOfAThreshold) {
  constexpr double kGap = 1.5;
  int found = 0;
  for (const Scene& scene : scenes()) {
    const test::EveryVertex gaps(scene.joint);
    for (const Vec3& axis : test::random_directions(3, 4)) {
      const Turning turning{scene.joint, axis};
      const auto start = gaps.least_gap({});
      if (start && start->gap_mm <= kGap) continue;
      const auto first = turning.gap(kGap, {0.0, kFarthest});
      for (const double angle : angles_before(first ? first->angle : kFarthest)) {
        const auto smallest = gaps.least_gap(turning.at(angle));
        ASSERT_TRUE(!smallest || smallest->gap_mm > kGap) << scene.name << " " << angle;
      }
      if (!first) continue;
      ++found;
      EXPECT_LE(gaps.least_gap(turning.at(first->angle + kBeyond))->gap_mm, kGap) << scene.name;
    }
  }
  EXPECT_GT(found, 5);
}

// A plate outside of a cap, which it never meets. As the centre sees them it is beyond the cap once it passes
// the rim, and has every gap of a threshold there: its tip leads at -60 degrees from -z, the rim is at 70
// degrees from +z, both across the plane y = 0. Either has a corner in that plane, and the other an edge
// across it.
BallSocketPair plate_and_cap(double plate_width, double rim_width) {
  const auto at = [](double radius, double degrees, double y) {
    return Vec3(-radius * std::sin(degrees * kDegree), y, radius * std::cos(degrees * kDegree));
  };
  const TriangleMesh plate{
      {at(40, 120, plate_width), at(40, 120, -plate_width), at(40, 170, 4), at(40, 170, -4)},
      {{0, 2, 1}, {1, 2, 3}}};
  const TriangleMesh cap{{at(26, 70, rim_width), at(26, 70, -rim_width), at(26, 0, 4), at(26, 0, -4)},
                         {{0, 2, 1}, {1, 2, 3}}};
  return {plate, cap};
}

TEST(TurnContact, KnowsARimBehindARim) {
  for (const auto& [plate_width, rim_width] :
       {std::pair(0.0, 9.0), std::pair(9.0, 0.0), std::pair(3.0, 9.0)}) {
    const BallSocketPair joint = plate_and_cap(plate_width, rim_width);
    const Turning turning{joint, Vec3::UnitY()};
    EXPECT_FALSE(turning.first({0.0, kFarthest})) << plate_width;
    for (const double gap_mm : {0.0, 1.0}) {
      const auto gap = turning.gap(gap_mm, {0.0, kFarthest});
      ASSERT_TRUE(gap) << plate_width;
      EXPECT_EQ(gap->kind, ContactKind::rims);
      EXPECT_NEAR(gap->angle, (180.0 - 60.0 - 70.0) * kDegree, 1e-8);
    }
    EXPECT_FALSE(Turning(joint, -Vec3::UnitY()).gap(1.0, {0.0, 1.0})) << "it turns away";
  }
}

// A corner of the ball at distance 5, a quarter turn away, meets the plane x = 3 after asin(3/5).
TEST(TurnContact, OfABallVertexIsAnArcsine) {
  const TriangleMesh ball{{{0, 5, 0}, {-0.5, 4.8, 0.3}, {-0.5, 4.8, -0.3}}, {{0, 1, 2}}};
  const TriangleMesh wall{{{3, -9, -9}, {3, 19, 0}, {3, -9, 9}}, {{0, 1, 2}}};
  const BallSocketPair joint{ball, wall};
  const auto first = Turning{joint, -Vec3::UnitZ()}.first({0.0, kFarthest});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, ContactKind::ball_vertex);
  EXPECT_NEAR(first->angle, std::asin(0.6), 1e-9);
  EXPECT_LE(first->angle, std::asin(0.6)) << "nothing touches before";
  EXPECT_NEAR((first->place - Vec3(3, 4, 0)).norm(), 0.0, 1e-7);
  EXPECT_NEAR(std::abs(first->normal.x()), 1.0, 1e-12);
}

// A corner of the socket at distance 5 and azimuth -30 degrees is met by the plane x = 3 of the ball, which
// turns backwards, where the plane is 5 from the centre: at azimuth acos(3/5).
TEST(TurnContact, OfASocketVertexIsAnArccosine) {
  const Vec3 corner = 5.0 * to_direction({0.5 * kPi, -kPi / 6.0});
  const TriangleMesh ball{{{3, -1, -9}, {3, 19, 0}, {3, -1, 9}}, {{0, 1, 2}}};
  const TriangleMesh socket{{corner, corner + Vec3(0.3, -0.5, 0.2), corner + Vec3(0.3, -0.5, -0.2)},
                            {{0, 1, 2}}};
  const BallSocketPair joint{ball, socket};
  const auto first = Turning{joint, -Vec3::UnitZ()}.first({0.0, kFarthest});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, ContactKind::socket_vertex);
  EXPECT_NEAR(first->angle, std::acos(0.6) + kPi / 6.0, 1e-9);
  EXPECT_NEAR((first->place - corner).norm(), 0.0, 1e-12);
}

// Edges that lie in one plane all the time: the faces z = 2 of both slide over each other. Corner (4, 0, 2)
// reaches the edge x = 2 where its azimuth is 60 degrees.
TEST(TurnContact, OfFacesThatSlideInOnePlane) {
  const TriangleMesh ball{{{4, 0, 2}, {3.5, -1, 2}, {2.6, -1, 2}}, {{0, 1, 2}}};
  const TriangleMesh wall{{{2, 3, 2}, {2, 4, 2}, {-1, 3.5, 2}}, {{0, 1, 2}}};
  const BallSocketPair joint{ball, wall};
  const auto first = Turning{joint, Vec3::UnitZ()}.first({0.0, kFarthest});
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->angle, kPi / 3.0, 1e-6);
  EXPECT_LE(first->angle, kPi / 3.0);
}

// Edges in one plane all the time, which come to touch along a tangent: end (9, 1.0625) passes the line
// x = 9.0625 where it is farthest out. (Pair 09232 of experiments/28_turns, whose steps gave out; the angles
// near zero that a full turn has too were then called contact.)
TEST(TurnContact, OfATangentInOnePlaneIsNotAtTheStart) {
  const TriangleMesh ball{{{9, -21.75, 1.0625}, {3.0625, -21.75, 20.4375}, {3, -30, 10}}, {{0, 1, 2}}};
  const TriangleMesh wall{{{9.0625, -21.75, -12.6875}, {9.0625, -21.75, 9.0625}, {12, -12, 1}}, {{0, 1, 2}}};
  const BallSocketPair joint{ball, wall};
  const auto first = Turning{joint, Vec3::UnitY()}.first({0.0, 3.0});
  ASSERT_TRUE(first);
  EXPECT_LE(first->angle, 0.11751164543144539);
  EXPECT_GT(first->angle, 0.11751164543144539 - 1e-3);
}

// Sides along the axis, that of the socket the shorter one, both 5 mm from it and a right angle apart: they
// meet head on, whether the wall is behind its side or beside it.
TEST(TurnContact, OfParallelEdgesIsAcrossBothOfThem) {
  const TriangleMesh ball{{{5, 0, -9}, {5, 0, 9}, {4, -1, 9}}, {{0, 1, 2}}};
  for (const Vec3& behind : {Vec3(-1, 7, 0), Vec3(-1, 3, 0)}) {
    const BallSocketPair joint{ball, {{behind, {0, 5, -2}, {0, 5, 2}}, {{0, 1, 2}}}};
    const auto first = Turning{joint, Vec3::UnitZ()}.first({0.0, kFarthest});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->kind, ContactKind::edges);
    EXPECT_NEAR(first->angle, 0.5 * kPi, 1e-9);
    EXPECT_LE(first->angle, 0.5 * kPi);
    EXPECT_NEAR((first->place - Vec3(0, 5, first->place.z())).norm(), 0.0, 1e-7);
    EXPECT_LE(std::abs(first->place.z()), 2.0);
    EXPECT_NEAR(std::abs(first->normal.x()), 1.0, 1e-6);
  }
}

TEST(TurnContact, IsNoneWithoutFaces) {
  const TriangleMesh ball{{{0, 5, 0}, {-0.5, 4.8, 0.3}, {-0.5, 4.8, -0.3}}, {{0, 1, 2}}};
  for (const BallSocketPair& joint : {BallSocketPair{ball, {}}, BallSocketPair{{}, ball}, BallSocketPair{}}) {
    const Turning turning{joint, Vec3::UnitZ()};
    EXPECT_FALSE(turning.first({0.0, 2.0 * kPi}));
    EXPECT_FALSE(turning.gap(100.0, {0.0, 2.0 * kPi}));
  }
}

TEST(TheoremTurn, SpansHoldAllAnglesThatAreNearZero) {
  for (const Sinusoid& f :
       {Sinusoid{3, -4, 2}, Sinusoid{1, 0, 1}, Sinusoid{0, 0, 1e-4}, Sinusoid{0, 2, -1}}) {
    const AngleSpans spans = near_zero(f, 1e-3);
    for (int k = 0; k <= 20000; ++k) {
      const double t = 2.0 * kPi * k / 20000.0;
      const bool near = std::abs(f.cosine * std::cos(t) + f.sine * std::sin(t) + f.constant) <= 1e-3;
      const bool held =
          std::ranges::any_of(spans, [t](const AngleSpan& s) { return s.from <= t && t <= s.to; });
      ASSERT_TRUE(held || !near) << t;
      ASSERT_TRUE(near || !held || std::abs(f.cosine) + std::abs(f.sine) < 1e-3) << t;
    }
  }
  EXPECT_EQ(near_zero({1, 1, 2}, 0.1).count, 0U);
}

// A ball with a spike in five walls of a cube: how far its tip is from a wall has a closed form. As near to
// contact as could be, no rotations are called free or blocked that are not all so, and no cut has another
// depth than it must.

constexpr double kWall = 26.0;   // mm from the centre
constexpr double kTilt = 0.2;    // radians from the wall's normal, +z, to the tip
constexpr double kReach = 0.05;  // radians, of the turns
constexpr std::array kCloseness{1e-3, 1e-6, 1e-8, 1e-10, 1e-12};  // to contact, as a share of the radius

// Well beside the side between the wall's two triangles.
Vec3 tip_direction() {
  return Eigen::AngleAxisd(0.4, Vec3::UnitZ()) * Vec3(std::sin(kTilt), 0.0, std::cos(kTilt));
}

// The rotation brings the tip, `length` mm out, to tip_direction(); all else of the ball is far inside.
BallSocketPair spike_in_walls(double length, const Eigen::Matrix3d& rotation) {
  BallSocketPair pair{octahedron(5.0), {}};
  pair.ball.vertices[4] = length * tip_direction();  // that along +z
  for (Vec3& x : pair.ball.vertices) x = rotation.transpose() * x;
  for (int k = 0; k < 8; ++k)
    pair.socket.vertices.push_back(
        kWall * Vec3((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, (k & 4) != 0 ? 1.0 : -1.0));
  // All but the one at -z, towards the centre.
  pair.socket.faces = {{4, 6, 5}, {5, 6, 7}, {0, 4, 1}, {1, 4, 5}, {2, 3, 6},
                       {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
  return pair;
}

// Turns by up to rho bring the tip p to |p| cos(tilt - rho) along the normal at most, and to
// |p| cos(tilt + rho) at least: all are free if that most is below the wall, all blocked if that least is
// not.
TEST(NearContact, NoRotationsAreFreeOrBlockedThatAreNotAllSo) {
  for (const Pose& pose : test::random_poses(5, kPi, 0.0, 25)) {
    for (const double sign : {-1.0, 1.0}) {
      const CellState state = sign < 0.0 ? CellState::free : CellState::blocked;
      const double length = kWall / std::cos(kTilt + sign * kReach);
      const CellTest test(spike_in_walls(length, pose.rotation));
      const auto found = [&](double short_of) {
        const double end = std::acos((kWall * (1.0 + sign * short_of)) / length);
        return CellSearch(test).decide(RotationBall{pose.rotation, sign * (end - kTilt)}).state;
      };
      for (const double close : kCloseness) {
        const CellState within = found(close);
        EXPECT_TRUE(within == state || (within == CellState::open && close < 1e-6)) << close;
        EXPECT_NE(found(-close), state) << close;
      }
    }
  }
}

// The turn leads the tip straight towards the normal. At its end the wall is nearest along the tip's ray, and
// what is beyond it, less the clearance, has to go.
TEST(NearContact, NoCutIsDeeperOrLessDeepThanItMustBe) {
  constexpr double kClearance = 0.5;
  const double may_stay = kWall / std::cos(kTilt - kReach) - kClearance;
  for (const Pose& pose : test::random_poses(5, kPi, 0.0, 26)) {
    RequiredLeg leg;
    leg.turn = {Eigen::Matrix3d::Identity(), tip_direction().cross(Vec3::UnitZ()).normalized(),
                pose.rotation};
    leg.growing = "flexion";
    leg.largest_deg = kReach / kDegree;
    const auto cut = [&](double length) {
      const BallSocketPair joint = spike_in_walls(length, pose.rotation);
      return least_radial_cut(joint.ball, SweptRadius(joint.socket, {leg}),
                              {.clearance_mm = kClearance, .least_mm3 = 1e-6});
    };
    for (const double close : kCloseness) {
      const double depth = close * may_stay;
      const Resection none = cut(may_stay - depth);
      EXPECT_TRUE(none.volume_mm3.low <= 0.0 && none.depth_mm.low <= 0.0) << close;
      const Resection some = cut(may_stay + depth);
      EXPECT_FALSE(some.empty()) << close;
      EXPECT_LE(some.depth_mm.low, depth + 1e-13) << close;  // the rounding of the depth itself
      EXPECT_GE(some.depth_mm.high, depth - 1e-13) << close;
    }
  }
}

}  // namespace
}  // namespace impinge
