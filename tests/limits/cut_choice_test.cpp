// SPDX-License-Identifier: GPL-3.0-or-later
// Which cut is chosen between two octahedra in one another, whose faces are from radius / sqrt(3) to radius
// away from the centre; and what a pose is said to be where no cut is left.
#include "limits/cut_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/meeting_faces.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

// Of a ball and of a socket that is `inside` mm from the centre where it is nearest.
CutChoice choice_between(double radius, double inside) {
  std::vector<std::uint32_t> all(8);
  std::iota(all.begin(), all.end(), 0U);
  const CutFaces ball = ball_faces({octahedron(radius), 0.0}, all, {}, {});
  const CutFaces socket = socket_faces({octahedron(inside * std::sqrt(3.0)), 0.0});
  return choose_cut(ball, socket, {all, all}, Vec3::UnitX());
}

// Distances of cuts are whole numbers of 1 / 1024 mm: 20 mm are one, and so are 20 + 1 / 1024 mm.
TEST(ChooseCut, TakesASphereOnlyIfItIsBetweenThemWhenItsRadiusIsRounded) {
  const CutChoice wide = choice_between(20.0, 20.0 + 2.0 / 1024.0);
  EXPECT_EQ(wide.cut.kind, ClearCut::Kind::sphere);
  EXPECT_EQ(wide.cut.at, 20 * 1024 + 1);
  EXPECT_EQ(wide.pairs(), 0.0);
  // Between them, but rounded to the ball's radius: no pair is divided by it.
  const CutChoice narrow = choice_between(20.0, 20.0 + 0.4 / 1024.0);
  EXPECT_EQ(narrow.cut.kind, ClearCut::Kind::plane);
  EXPECT_LT(narrow.pairs(), 64.0);
}

TEST(ChooseCut, TakesNoSphereOfLessThanTheUnit) {
  EXPECT_EQ(choice_between(2.0 / 1024.0, 4.0 / 1024.0).cut.kind, ClearCut::Kind::sphere);
  EXPECT_EQ(choice_between(0.2 / 1024.0, 0.4 / 1024.0).cut.kind, ClearCut::Kind::plane);
}

// Triangles are apart exactly where some direction of the test separates them.
TEST(WidestGap, IsAboveZeroExactlyWhereTrianglesAreApart) {
  test::Dice dice(91);
  int apart = 0;
  int meeting = 0;
  for (std::size_t k = 0; k < 10 * random_cases(); ++k) {
    const auto any = [&] { return Triangle{dice.vector(), dice.vector(), dice.vector()}; };
    const Triangle a = any();
    Triangle b = any();
    for (Vec3& x : b) x += dice.between(0.0, 2.0) * Vec3::UnitX();
    const CutGap found = widest_gap(a, b);
    ASSERT_NEAR(found.direction.norm(), 1.0, 1e-12);
    double least = HUGE_VAL;
    for (const Vec3& x : a) {
      for (const Vec3& y : b) least = std::min(least, std::abs(found.direction.dot(y - x)));
    }
    if (std::abs(found.mm) < 1e-9) continue;
    const bool meet = faces_meet(a, b);
    ASSERT_EQ(found.mm > 0.0, !meet) << k;
    if (!meet) {
      EXPECT_NEAR(found.mm, least, 1e-12);
    }
    ++(meet ? meeting : apart);
  }
  EXPECT_GT(std::min(apart, meeting), static_cast<int>(random_cases()));
}

TriangleMesh many_times(const TriangleMesh& mesh, std::size_t times) {
  TriangleMesh many = mesh;
  many.faces.assign(times, mesh.faces.front());
  return many;
}

// Faces that are there 17 times make more pairs than are asked for a crossing at once, and no cut divides
// them.
TEST(ClearCuts, FacesThatAreThereManyTimesCrossAsOneDoes) {
  const TriangleMesh floor{{{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}}, {{0, 1, 2}}};
  const CutMotion pose{.last = half_angle(0.0)};
  const auto answer = [&](double tip) {
    const TriangleMesh above{{{0, 0, tip}, {1, 0, 2}, {0, 1, 2}}, {{0, 1, 2}}};
    return clear_cuts({many_times(above, 17), 1e-9}, {many_times(floor, 17), 1e-9}, pose);
  };
  EXPECT_TRUE(answer(-1.0).crossing) << "it reaches through";
  const CutAnswer touching = answer(0.0);
  EXPECT_FALSE(touching.crossing) << "rounding may have made it touch";
  ASSERT_TRUE(touching.open);
  EXPECT_EQ(touching.open->degrees, 0.0);
  EXPECT_FALSE(answer(0.1).crossing || answer(0.1).open);
}

// Edges that cross a fiftieth of a millimetre above each other, of faces that lean away: only directions
// within 0.1 degrees of the normal of both edges separate them, which is looked for if no other cut helps.
TEST(ClearCuts, FacesThatAreThereManyTimesAreApartAsOneIs) {
  const Vec3 n = Vec3(1, 2, 3).normalized();
  const Vec3 u = n.unitOrthogonal();
  const Vec3 w = (u + n.cross(u)).normalized();
  const TriangleMesh below{{-5 * u, 5 * u, -6 * n + 3 * n.cross(u)}, {{0, 1, 2}}};
  const TriangleMesh above{{0.02 * n - 5 * w, 0.02 * n + 5 * w, 6 * n + 3 * n.cross(w)}, {{0, 1, 2}}};
  for (const std::size_t times : {1U, 17U}) {
    const CutAnswer found = clear_cuts({many_times(below, times), 1e-9}, {many_times(above, times), 1e-9},
                                       {.last = half_angle(0.0)});
    EXPECT_FALSE(found.crossing || found.open) << times;
    EXPECT_LT(found.cuts.size(), 20U) << times;
  }
}

TEST(HalfAngle, OfNothingIsThatOfAPose) {
  EXPECT_EQ(half_angle(0.0), (HalfAngle{1, 0}));
  EXPECT_EQ(degrees_of(half_angle(0.0)), 0.0);
  EXPECT_NEAR(degrees_of(half_angle(200.0)), 200.0, 1e-6);
}

}  // namespace
}  // namespace impinge
