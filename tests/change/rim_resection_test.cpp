// SPDX-License-Identifier: GPL-3.0-or-later
// The least radial cut of a socket: its size beside an integral over a formula, what it leaves beside the
// exact overlay, and what one hair less would leave.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "change/resection.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "limits/bump_under_a_cup.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"
#include "mesh/weld.hpp"
#include "rotations/bone_along_rays.hpp"
#include "rotations/bone_over_cap.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

// How far out the bump comes along v on its way from 28 degrees below the edge of the cup to 62 above it: its
// radius at the angle from v to the way of its top.
double farthest_of_bump(const Vec3& v) {
  const double along = std::clamp(std::atan2(v.z(), v.x()), -28.0 * kDegree, 62.0 * kDegree);
  const Vec3 top(std::cos(along), 0.0, std::sin(along));
  return bump_radius(std::acos(std::min(1.0, v.dot(top))));
}

// What has to go of a cup of bone for a clearance of 0.5 mm, by the midpoint rule. Rays come into bone at the
// first radius, leave it at the second, and so on.
struct CutOfCup {
  double area_mm2 = 0.0;
  double volume_mm3 = 0.0;
};
CutOfCup cut_of_cup(const std::vector<double>& radii, double half_opening = 87.0 * kDegree) {
  constexpr int kPolar = 600;
  constexpr int kAround = 1200;
  CutOfCup cut;
  for (int i = 0; i < kPolar; ++i) {
    const double polar = (i + 0.5) * half_opening / kPolar;
    const double angle = std::sin(polar) * half_opening / kPolar * 2.0 * kPi / kAround;
    for (int k = 0; k < kAround; ++k) {
      const double turn = (k + 0.5) * 2.0 * kPi / kAround;
      const double clear = 0.5 + farthest_of_bump({std::sin(polar) * std::cos(turn),
                                                   std::sin(polar) * std::sin(turn), std::cos(polar)});
      double sign = 1.0;
      for (const double radius : radii) {
        if (clear > radius) {
          cut.area_mm2 += angle * radius * radius;
          cut.volume_mm3 += sign * angle * (std::pow(clear, 3) - std::pow(radius, 3)) / 3.0;
        }
        sign = -sign;
      }
    }
  }
  return cut;
}

void expect_near_ends(const Ends& ends, double value, double slack) {
  EXPECT_LE(ends.low, value * (1.0 + slack));
  EXPECT_GE(ends.high, value * (1.0 - slack));
}

// Few faces, so that the test is short: ends of the volume close as slowly as leaves get narrower.
constexpr CutQuestion kEnoughForATest{
    .clearance_mm = 0.5, .closeness = 0.1, .least_mm3 = 0.5, .depth_mm = 0.2, .most_new_faces = 15'000};

double share_between(const Ends& ends) { return (ends.high - ends.low) / ends.low; }

TEST(RimResection, OfASheetIsTheIntegralOverAFormula) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  const Resection cut = least_radial_cut(joint.socket, swept, kEnoughForATest);
  expect_near_ends(cut.area_mm2, cut_of_cup({kCupRadius}).area_mm2, 0.004);
  EXPECT_LT(share_between(cut.area_mm2), 0.12);
  expect_near_ends(cut.depth_mm, kHeadRadius + kBumpHeight + 0.5 - kCupRadius, 0.01);
  EXPECT_LT(share_between(cut.depth_mm), 0.1);
  EXPECT_EQ(cut.volume_mm3.low, 0.0);
  EXPECT_EQ(cut.volume_mm3.high, HUGE_VAL) << "no wall says how thick the bone is";
  EXPECT_TRUE(std::isnan(cut.cut_mm3));
}

// Where all of a wall goes the mesh is open; of a thick one some bone is left everywhere.
TEST(RimResection, OfAWallIsTheIntegralOverAFormula) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  for (const double outside : {kWallRadius, 29.5}) {
    const bool thick = outside > kWallRadius;
    const Resection cut = least_radial_cut(cup_with_a_wall(outside), swept, kEnoughForATest);
    const CutOfCup formula = cut_of_cup({kCupRadius, outside});
    expect_near_ends(cut.volume_mm3, formula.volume_mm3, 0.02);
    expect_near_ends(cut.area_mm2, formula.area_mm2, 0.02);
    expect_near_ends(cut.depth_mm, std::min(outside, kHeadRadius + kBumpHeight + 0.5) - kCupRadius,
                     thick ? 0.01 : 0.03);
    EXPECT_LT(share_between(cut.volume_mm3), thick ? 0.35 : 0.18);
    EXPECT_EQ(std::isnan(cut.cut_mm3), !thick);
    if (!thick) {
      EXPECT_LT(share_between(cut.area_mm2), 0.3);
      EXPECT_LT(share_between(cut.depth_mm), 0.1);
    } else {
      EXPECT_GE(cut.cut_mm3, cut.volume_mm3.low);
      EXPECT_LE(cut.cut_mm3, 1.3 * formula.volume_mm3);
      EXPECT_EQ(cut.cut.faces.size(), cut.before.faces.size());
    }
  }
}

// A block over the way of the bump. Its walls lie exactly in planes through the centre; vertices of the ring
// in the middle belong to no other faces.
constexpr double kBlockRing = 1.0625;  // times the vertices of its inner side
constexpr double kBlockBack = 1.25;
const std::array<Vec3, 4> kBlockInside{
    {{20.0, -2.0, 14.0}, {20.0, 2.0, 14.0}, {14.0, 2.0, 20.0}, {14.0, -2.0, 20.0}}};

TriangleMesh block_with_edge_on_walls() {
  TriangleMesh block;
  for (const double share : {1.0, kBlockRing, kBlockBack})
    for (const Vec3& x : kBlockInside) block.vertices.emplace_back(share * x);
  block.faces = {{0, 1, 2}, {0, 2, 3}, {8, 10, 9}, {8, 11, 10}};
  for (const VertexIndex ring : {0U, 4U}) {
    for (VertexIndex k = 0; k < 4; ++k) {
      const VertexIndex a = ring + k;
      const VertexIndex b = ring + (k + 1) % 4;
      block.faces.push_back({a, a + 4, b});
      block.faces.push_back({b, a + 4, b + 4});
    }
  }
  return block;
}

// Of the inner side all goes; of a wall s (a + t (b - a)) between two of its corners what is below s = K.
double cut_area_of_block(double clearance) {
  const auto& [a, b, c, d] = kBlockInside;
  double area = (b - a).cross(d - a).norm();
  constexpr int kSteps = 1000;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& from = kBlockInside[k];
    const Vec3& to = kBlockInside[(k + 1) % 4];
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 x = from + (i + 0.5) / kSteps * (to - from);
      const double goes = std::min(kBlockBack, (clearance + farthest_of_bump(x.normalized())) / x.norm());
      area += 0.5 * (goes * goes - 1.0) * from.cross(to).norm() / kSteps;
    }
  }
  return area;
}

TEST(RimResection, TakesWallsThatTheCentreSeesEdgeOn) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  const TriangleMesh block = block_with_edge_on_walls();
  for (std::size_t f = 4; f < block.faces.size(); ++f) ASSERT_TRUE(cone_of(block, block.faces[f]).edge_on());
  CutQuestion question = kEnoughForATest;
  question.most_new_faces = 2000;
  const Resection cut = least_radial_cut(block, swept, question);
  expect_near_ends(cut.area_mm2, cut_area_of_block(0.5), 0.01);
  EXPECT_LT(share_between(cut.area_mm2), 1.0);
  EXPECT_EQ(cut.cut.faces.size(), cut.before.faces.size()) << "the block is thicker than what goes";
  double least = HUGE_VAL;
  for (const Vec3& x : cut.cut.vertices) least = std::min(least, x.norm() - farthest_of_bump(x.normalized()));
  EXPECT_GT(least, 0.4);  // the clearance but for what flat faces of the bump are below the formula
}

// The ray that is counted passes no edge-on wall, and no edge: else others are tried. A cap of one direction
// along an edge has no other ray; there nothing is certain.
TEST(TheoremSweep, HoldsABlockWithEdgeOnWalls) {
  const BoneOverCap bone(block_with_edge_on_walls());
  test::Dice dice(9);
  const auto& [a, b, c, d] = kBlockInside;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const double x = k % 3 == 0 ? 0.0 : dice.between(0.0, 1.0);  // along an edge
    const double y = k % 5 == 0 ? x : dice.between(0.0, 1.0);    // along the diagonal
    const Vec3 at = a + x * (b - a) + y * (d - a);
    const DirectionCap cap{at.normalized(), k % 2 == 0 ? 0.0 : dice.power(-6.0, -2.0)};
    const SpansOverCap found = bone.over(cap);
    EXPECT_TRUE(found.possible.holds(at.norm(), kBlockBack * at.norm())) << k;
    for (const RadiusRange& s : found.certain.spans()) {
      EXPECT_GE(s.low, at.norm() * (1.0 - 1e-6)) << k;
      EXPECT_LE(s.high, at.norm() * kBlockBack * (1.0 + 1e-6)) << k;
    }
    if (cap.radius == 0.0 && (x == 0.0 || x == y)) {
      EXPECT_TRUE(found.certain.spans().empty()) << k;
    }
  }
}

// A wall inside out holds the same bone.
TEST(RimResection, OfAWallInsideOutIsTheSame) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  CutQuestion question = kEnoughForATest;
  question.most_new_faces = 1000;
  const TriangleMesh socket = cup_with_a_wall();
  const Resection cut = least_radial_cut(socket, swept, question);
  const Resection turned = least_radial_cut(test::inside_out(socket), swept, question);
  EXPECT_GT(cut.volume_mm3.low, 100.0);
  EXPECT_NEAR(turned.volume_mm3.low, cut.volume_mm3.low, 0.05 * cut.volume_mm3.low);
  EXPECT_NEAR(turned.volume_mm3.high, cut.volume_mm3.high, 0.05 * cut.volume_mm3.high);
  EXPECT_EQ(turned.cut.faces.size(), cut.cut.faces.size());
}

// Spheres about the centre with bone outside of the first, inside of the second, and so on.
TriangleMesh spheres(const std::vector<double>& radii) {
  TriangleMesh all;
  bool outwards = false;
  for (const double radius : radii) {
    const TriangleMesh one = revolve({sphere_rings(radius, kPi, 4.0 * kDegree), Vec3::UnitZ(), {}, 90});
    all = test::joined(std::move(all), outwards ? one : test::inside_out(one));
    outwards = !outwards;
  }
  return all;
}

TEST(RimResection, OfShellsAllRoundIsTheIntegralOverAFormula) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  CutQuestion question = kEnoughForATest;
  question.most_new_faces = 5000;
  for (const std::vector<double>& radii : {std::vector{26.0, 30.0}, std::vector{26.0, 27.0, 28.0, 30.0}}) {
    const TriangleMesh shells = spheres(radii);
    ASSERT_GT(validate(shells).volume, 0.0);
    const CutOfCup formula = cut_of_cup(radii, kPi);
    for (const TriangleMesh& socket : {shells, test::inside_out(shells)}) {
      const Resection cut = least_radial_cut(socket, swept, question);
      expect_near_ends(cut.volume_mm3, formula.volume_mm3, 0.01);
      expect_near_ends(cut.area_mm2, formula.area_mm2, 0.01);
      expect_near_ends(cut.depth_mm, 2.5, 0.02);
      EXPECT_LT(cut.volume_mm3.high, 4.0 * formula.volume_mm3);  // of a thin wall the ends close slowly
    }
  }
}

// Bone all beyond a sphere has no outer side.
TEST(RimResection, KnowsNoVolumeOfOneSurfaceAllRound) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  const TriangleMesh sphere = spheres({kCupRadius});
  CutQuestion question = kEnoughForATest;
  question.most_new_faces = 2000;
  for (const TriangleMesh& socket : {sphere, test::inside_out(sphere), spheres({kCupRadius, 27.0, 29.0})}) {
    const Resection cut = least_radial_cut(socket, swept, question);
    EXPECT_EQ(cut.volume_mm3.high, HUGE_VAL);
    EXPECT_TRUE(std::isnan(cut.cut_mm3));
    expect_near_ends(cut.depth_mm, 2.5, 0.02);
    EXPECT_LT(share_between(cut.depth_mm), 0.1);
    EXPECT_THROW(BoneOverCap{socket}, std::runtime_error);
  }
}

// The sum over faces is bone only where all shells are the same way round.
TEST(RimResection, KnowsNoVolumeOfShellsThatAreNotOfOneOrientation) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  CutQuestion question = kEnoughForATest;
  question.most_new_faces = 500;
  const TriangleMesh block = block_with_edge_on_walls();
  const auto volume = [&](const TriangleMesh& other) {
    return least_radial_cut(test::joined(block, other), swept, question).volume_mm3;
  };
  TriangleMesh within = block;
  const Vec3 middle(17.0 * 1.125, 0.0, 17.0 * 1.125);
  for (Vec3& x : within.vertices) x = 0.5 * (middle + x);
  TriangleMesh mirrored = block;
  for (Vec3& x : mirrored.vertices) x *= -1.25;
  for (const Ends& known :
       {volume(test::inside_out(mirrored)), volume(test::inside_out(within)), volume(within)}) {
    EXPECT_LE(known.low, known.high);
    EXPECT_NEAR(known.high, 200.0, 100.0);
  }
  TriangleMesh across = test::inside_out(block);  // over the back of the block
  for (Vec3& x : across.vertices) x *= 1.125;
  for (const TriangleMesh& other : {mirrored, across}) {
    EXPECT_EQ(volume(other).high, HUGE_VAL);
    EXPECT_THROW(BoneOverCap{test::joined(block, other)}, std::runtime_error);
  }
}

// A cube round the centre in an octahedron: the middle of each face is seen along an edge of the other, so
// that no ray there tells anything.
TEST(LeastCut, IsRefusedWhereRaysTellNothing) {
  TriangleMesh mesh = octahedron(30.0);
  for (Eigen::Index k = 0; k < 3; ++k)
    for (const double at : {-5.0, 5.0}) {
      const Vec3 middle = at * Vec3::Unit(k);
      const Vec3 across = 5.0 * Vec3::Unit((k + 1) % 3);
      const Vec3 up = at * Vec3::Unit((k + 2) % 3);
      const std::array<Vec3, 4> corners{middle + across + up, middle - across + up, middle - across - up,
                                        middle + across - up};
      for (std::size_t l = 0; l < 4; ++l) test::add_face(mesh, middle, corners[l], corners[(l + 1) % 4]);
    }
  mesh = weld(mesh);
  ASSERT_TRUE(validate(mesh).volume);
  EXPECT_FALSE(is_bone_beside_centre(mesh));
  EXPECT_THROW(BoneOverCap{mesh}, std::runtime_error);
}

// A pincer that is to reach more than it does, with or without a wall.
struct PincerThatTurnsFarther {
  explicit PincerThatTurnsFarther(double wall_mm)
      : hip(make_hip(
            [&] {
              HipParameters parameters = hip_preset("pincer");
              parameters.wall_thickness = wall_mm;
              return parameters;
            }(),
            4000)),
        legs(required_legs(parse_motion("flexion=90,internal_rotation=35"), Side::right)),
        swept(hip.ball, legs, Surface::socket),
        cut(least_radial_cut(hip.socket, swept, kEnoughForATest)) {}
  Hip hip;
  std::vector<RequiredLeg> legs;
  SweptRadius swept;
  Resection cut;
};

TEST(TheoremResection, LetsTheBallReachAllThatWasRequired) {
  for (const double wall_mm : {0.0, 4.0}) {
    const PincerThatTurnsFarther pincer(wall_mm);
    ASSERT_FALSE(pincer.cut.empty());
    const TurnLimits before({pincer.hip.ball, pincer.hip.socket});
    const TurnLimits after({pincer.hip.ball, pincer.cut.cut});
    EXPECT_EQ(before.first_contact(pincer.legs[1].turn, pincer.legs[1].largest_deg).state,
              LimitState::limited);
    for (const RequiredLeg& leg : pincer.legs) {
      EXPECT_EQ(after.first_contact(leg.turn, leg.largest_deg).state, LimitState::free) << describe(leg);
      EXPECT_EQ(after.gap_of(leg.turn, 0.5 * (1.0 - 1e-6), leg.largest_deg).state, LimitState::free);
    }
  }
}

// Contact comes back where a vertex stands a hair within F, and not where it stands a hair beyond.
TEST(TheoremResection, TakesNoMoreThanItMust) {
  const PincerThatTurnsFarther pincer(0.0);
  const Vec3 at = pincer.cut.cut.vertices[pincer.cut.deepest];
  const Ends most = pincer.swept.over({at.normalized(), 1e-6}, 0.0);
  ASSERT_LT(most.high - most.low, 0.01);
  const auto free_at = [&](double radius) {
    TriangleMesh socket = pincer.cut.cut;
    socket.vertices[pincer.cut.deepest] = radius * at.normalized();
    const TurnLimits limits({pincer.hip.ball, socket});
    return std::ranges::all_of(pincer.legs, [&](const RequiredLeg& leg) {
      return limits.first_contact(leg.turn, leg.largest_deg).state == LimitState::free;
    });
  };
  EXPECT_TRUE(free_at(most.high + 0.01));
  EXPECT_FALSE(free_at(most.low - 0.01));
}

TEST(RimResection, RefusesAFaceThatIsTooWide) {
  const BallSocketPair joint = bump_under_a_cup(40, 2.5);
  const SweptRadius swept(joint.ball, {turn_about_y(90.0)}, Surface::socket);
  const TriangleMesh wide{{{20.0, -70.0, -1.0}, {20.0, 70.0, -1.0}, {20.0, 0.0, 70.0}}, {{0, 1, 2}}};
  EXPECT_EQ(test::thrown<std::runtime_error>([&] { least_radial_cut(wide, swept, {.most_new_faces = 0}); }),
            "a face of the socket is too wide to be cut; give a mesh of smaller faces");
}

}  // namespace
}  // namespace impinge
