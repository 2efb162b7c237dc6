// SPDX-License-Identifier: GPL-3.0-or-later
// Shadow of Y = {s y : y in Y, s >= 1}, in closed form and against points of it.
#include "reference/shadow.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge {
namespace {

const Triangle kFace{Vec3(-1, -1, 2), Vec3(1, -1, 2), Vec3(0, 1, 2)};

TEST(Shadow, BeginsAtTheFaceAndHasNoEnd) {
  EXPECT_TRUE(in_shadow({0, 0, 2}, kFace));
  EXPECT_TRUE(in_shadow({0, 0, 2000}, kFace));
  EXPECT_FALSE(in_shadow({0, 0, std::nextafter(2.0, 1.0)}, kFace));
  EXPECT_TRUE(in_pyramid({0, 0, 2}, kFace));
  EXPECT_TRUE(in_pyramid({0, 0, 1e-9}, kFace));
  EXPECT_FALSE(in_pyramid({0, 0, std::nextafter(2.0, 3.0)}, kFace));
  EXPECT_TRUE(in_shadow({3, -3, 6}, kFace));  // on an edge of it
  EXPECT_FALSE(in_shadow({std::nextafter(3.0, 4.0), -3, 6}, kFace));
  EXPECT_FALSE(in_shadow({0, 0, -4}, kFace));
  EXPECT_FALSE(in_pyramid({0, 0, -1}, kFace));
  EXPECT_FALSE(in_shadow({0, 0, 4}, {Vec3(1, 0, 2), Vec3(-1, 0, 2), Vec3(0, 0, 3)}));  // edge-on
}

TEST(Shadow, DoesNotDependOnTheOrderOfCorners) {
  const Triangle turned{kFace[1], kFace[0], kFace[2]};
  for (const Vec3& x : {Vec3(0.1, 0.2, 2.5), Vec3(0.1, 0.2, 1.5), Vec3(5, 0, 2)}) {
    EXPECT_EQ(in_shadow(x, kFace), in_shadow(x, turned));
    EXPECT_EQ(in_pyramid(x, kFace), in_pyramid(x, turned));
  }
}

// A face whose corners are all before the other, and an edge of which is behind an edge of it.
TEST(Shadow, IsMetByAnEdgeAlone) {
  const Triangle bar{Vec3(-3, 0.1, 2.01), Vec3(3, 0.1, 2.01), Vec3(0, 5, 1)};
  EXPECT_TRUE(meets_shadow(bar, kFace));
  for (const Vec3& x : bar) EXPECT_FALSE(in_shadow(x, kFace));
  const Triangle nearer{Vec3(-3, 0.1, 1.99), Vec3(3, 0.1, 1.99), Vec3(0, 5, 1)};
  EXPECT_FALSE(meets_shadow(nearer, kFace));
  const Triangle touching{Vec3(-3, 0, 2), Vec3(3, 0, 2), Vec3(0, 5, 1)};
  EXPECT_TRUE(meets_shadow(touching, kFace));
}

// A face in a plane through the centre is met by none, and meets others by its points: 0.1 mm beyond, on the
// shadow's own side, and before it.
TEST(Shadow, IsMetByAFaceInAPlaneThroughTheCentre) {
  const Triangle edge_on{Vec3(0, -3, 2.1), Vec3(0, 3, 2.1), Vec3(0, 0, 1)};
  EXPECT_FALSE(covers_directions(edge_on));
  EXPECT_TRUE(covers_directions(kFace));
  EXPECT_TRUE(meets_shadow(edge_on, kFace));
  EXPECT_FALSE(meets_shadow(kFace, edge_on));
  EXPECT_TRUE(meets_pyramid(edge_on, kFace));
  EXPECT_FALSE(meets_pyramid(kFace, edge_on));
  EXPECT_FALSE(meets_shadow({Vec3(0, -3, 1.9), Vec3(0, 3, 1.9), Vec3(0, 0, 1)}, kFace));
  EXPECT_FALSE(meets_pyramid({Vec3(0, -3, 2.1), Vec3(0, 3, 2.1), Vec3(0, 0, 4)}, kFace));
  const Triangle through{Vec3(40, 0, 0), Vec3(-40, 30, 0), Vec3(-40, -30, 0)};  // the centre is in it
  EXPECT_TRUE(meets_pyramid(through, kFace));
  EXPECT_FALSE(meets_shadow(through, kFace));
}

// Points a + i (b - a) / n + j (c - a) / n of one face in the shadow of the other: if there is one the faces
// meet the shadow, and without any they do so by less than a step.
TEST(Shadow, AgreesWithPointsOfTheFaces) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> component(-1.0, 1.0);
  const auto corner = [&] { return Vec3(component(random), component(random), 2.0 + component(random)); };
  int met = 0;
  int differ = 0;
  constexpr int kSteps = 24;
  for (int k = 0; k < 500; ++k) {
    const Triangle ball{corner(), corner(), corner()};
    const Triangle socket{corner(), corner(), corner()};
    bool sampled = false;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 x = ball[0] + i * (ball[1] - ball[0]) / kSteps + j * (ball[2] - ball[0]) / kSteps;
        sampled = sampled || in_shadow(x, socket);
      }
    }
    const bool exact = meets_shadow(ball, socket);
    ASSERT_TRUE(exact || !sampled);
    met += exact ? 1 : 0;
    differ += exact != sampled ? 1 : 0;
  }
  EXPECT_GT(met, 100);
  EXPECT_LT(met, 400);
  EXPECT_LT(differ, 25);
}

TEST(ShadowReference, OfConcentricSpheresIsTheirOrder) {
  const TriangleMesh small = sphere(10.0, 80);
  const TriangleMesh large = sphere(20.0, 60);
  const ShadowReference inside(small, large);
  EXPECT_FALSE(inside.ball_beyond_socket());
  EXPECT_FALSE(inside.socket_within_ball());
  for (const bool impinged : inside.ball_vertices_impinged()) EXPECT_FALSE(impinged);
  for (const bool impinged : inside.socket_vertices_impinged()) EXPECT_FALSE(impinged);
  const ShadowReference outside(large, small);
  EXPECT_TRUE(outside.ball_beyond_socket());
  EXPECT_TRUE(outside.socket_within_ball());
  for (const bool impinged : outside.ball_vertices_impinged()) EXPECT_TRUE(impinged);
  for (const bool impinged : outside.socket_vertices_impinged()) EXPECT_TRUE(impinged);
}

}  // namespace
}  // namespace impinge
