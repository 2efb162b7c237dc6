// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle is the exact distance from the nearest point of the mesh:
//   lower <= d <= upper,   for any mesh and any point
#include "10_euclidean/gap_bracket.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/pose.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/closest_point.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/soup.hpp"

namespace impinge::lab {
namespace {

struct Found {
  std::vector<DistanceEnds> bracket;
  std::vector<double> distance;
  std::size_t bounded = 0;  // points with a lower end above zero
};

Found look_at(const TriangleMesh& mesh, const std::vector<Vec3>& points) {
  Found found;
  const GapBracket bracket(mesh);
  for (const Vec3& x : points) found.bracket.push_back(bracket.at(x));
  found.distance = closest_distances(mesh, {.points = points});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(found.bracket[i].lower_mm, found.distance[i]) << i << ": " << points[i].transpose();
    EXPECT_GE(found.bracket[i].upper_mm, found.distance[i]) << i << ": " << points[i].transpose();
    found.bounded += found.bracket[i].lower_mm > 0.0;
  }
  return found;
}

// Directions at random, at radii from low to high.
std::vector<Vec3> points_between(double low, double high, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> radius(low, high);
  std::vector<Vec3> points = test::random_directions(count, seed + 1);
  for (Vec3& x : points) x *= radius(random);
  return points;
}

std::vector<Pose> poses() {
  const auto turn = [](double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * kDegree, axis.normalized()).toRotationMatrix();
  };
  return {{},
          {turn(-40.0, {0, 1, 0}), {0, 0, 0}},
          {turn(75.0, {1, 2, -1}), {1.5, -0.5, 3.0}},
          {turn(20.0, {0, 0, 1}), {0.0, 6.0, 1.0}}};
}

TEST(GapBracket, IsNarrowBetweenConcentricSpheres) {
  const TriangleMesh outer = sphere(26.0, 20000);
  for (const double radius : {22.0, 25.9, 26.1, 30.0}) {
    const Found found = look_at(outer, points_between(radius, radius, 200, 1));
    for (const DistanceEnds& b : found.bracket) EXPECT_GT(b.lower_mm, 0.998 * b.upper_mm) << radius;
  }
}

// A sphere about e is met at up to asin(|e| / R): the ends are no farther apart than the slopes near a point
// ask for.
TEST(GapBracket, IsNarrowInAnEccentricSphere) {
  const Found found = look_at(sphere(25.0, 3000, {5.0, 0.0, 0.0}), points_between(20.0, 26.0, 300, 2));
  for (const DistanceEnds& b : found.bracket) {
    if (b.upper_mm > 4.0) continue;
    EXPECT_GT(b.lower_mm, 0.93 * b.upper_mm);
  }
  EXPECT_GT(found.bounded, 290U);
}

TEST(GapBracket, HoldsForThePairInEveryPose) {
  const BallSocketPair pair = make_ball_socket_pair(600, impinging_cam());
  for (const Pose& pose : poses()) {
    std::vector<Vec3> ball = pair.ball.vertices;
    for (Vec3& x : ball) x = to_socket(pose, x);
    std::vector<Vec3> socket = pair.socket.vertices;
    for (Vec3& x : socket) x = to_ball(pose, x);
    EXPECT_GT(look_at(pair.socket, ball).bounded, ball.size() / 2);
    EXPECT_GT(look_at(pair.ball, socket).bounded, socket.size() / 2);
  }
}

// Any layers, cliffs and rims at all, and points on all sides of them.
TEST(GapBracket, HoldsForTrianglesAtRandom) {
  std::size_t bounded = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    for (const std::size_t faces : {3U, 20U, 150U}) {
      const TriangleMesh mesh = test::soup(faces, 10 * seed + 1);
      std::vector<Vec3> points = points_between(1.0, 60.0, 60, seed);
      for (const Face& face : mesh.faces) {  // close to a face
        const Vec3 middle = (corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2)) / 3.0;
        points.push_back(1.01 * middle);
      }
      bounded += look_at(mesh, points).bounded;
    }
  }
  EXPECT_GT(bounded, 1000U);
}

TEST(GapBracket, IsThatOfThePlaneNextToALargeFace) {
  const TriangleMesh plane{{{100, 100, 10}, {-100, 0, 10}, {100, -100, 10}}, {{0, 1, 2}}};
  for (const double degrees : {0.0, 20.0, 45.0, 60.0}) {
    const Vec3 u(std::sin(degrees * kDegree), 0.0, std::cos(degrees * kDegree));
    for (const double share : {0.999, 1.001}) {
      const Vec3 x = share * 10.0 / u.z() * u;
      const DistanceEnds found = GapBracket(plane).at(x);
      EXPECT_LE(found.lower_mm, std::abs(x.z() - 10.0));
      EXPECT_GE(found.upper_mm, std::abs(x.z() - 10.0));
    }
  }
}

// Rings about +z: r = R exp(-t angle), as steep as t everywhere, out to 0.6 rad.
TriangleMesh funnel(double radius, double slope) {
  constexpr std::size_t kSides = 128;
  constexpr std::size_t kRings = 60;
  TriangleMesh mesh{{{0, 0, radius}}, {}};
  const auto vertex = [](std::size_t ring, std::size_t side) {
    return static_cast<VertexIndex>(ring == 0 ? 0 : 1 + (ring - 1) * kSides + side % kSides);
  };
  for (std::size_t ring = 1; ring <= kRings; ++ring) {
    const double angle = 0.01 * static_cast<double>(ring);
    for (std::size_t side = 0; side < kSides; ++side) {
      const double theta = 2.0 * kPi * static_cast<double>(side) / static_cast<double>(kSides);
      mesh.vertices.push_back(radius * std::exp(-slope * angle) * to_direction({angle, theta}));
      mesh.faces.push_back({vertex(ring - 1, side), vertex(ring, side), vertex(ring, side + 1)});
      if (ring == 1) continue;
      mesh.faces.push_back({vertex(ring - 1, side), vertex(ring, side + 1), vertex(ring - 1, side + 1)});
    }
  }
  return mesh;
}

// It comes nearer to a point on its axis than 1 / cos psi allows: the ratio k counts.
TEST(GapBracket, TheRatioOfRadiiCountsInAFunnel) {
  const Vec3 x(0.0, 0.0, 30.0 * std::exp(-0.3));
  const Found found = look_at(funnel(30.0, 1.0), {x});
  EXPECT_LT(found.distance[0], 0.96 * (30.0 - x.norm()) / std::sqrt(2.0));
  EXPECT_GT(found.bracket[0].lower_mm, 0.75 * found.distance[0]);
}

// The gap of the layer that a table keeps says nothing here: another layer is nearer, a wall without any
// direction, or the other side of a rim.
TEST(GapBracket, SeesOtherLayersWallsAndRims) {
  const TriangleMesh shells = test::joined(sphere(20.0, 2000), sphere(30.0, 2000));
  for (const DistanceEnds& b : look_at(shells, points_between(28.0, 28.0, 50, 3)).bracket)
    EXPECT_NEAR(b.lower_mm, 2.0, 0.1);

  TriangleMesh wall = sphere(20.0, 2000);
  test::add_face(wall, {0, 0, 25}, {0, 0, 35}, {0, 10, 30});
  const std::vector<Vec3> beside{{0.1, 3.0, 30.0}, {-0.1, 1.0, 26.0}};
  for (const double distance : look_at(wall, beside).distance) EXPECT_LT(distance, 0.11);

  std::vector<Vec3> beyond = points_between(20.0, 32.0, 300, 4);
  std::erase_if(beyond, [](const Vec3& x) { return x.z() > 0.0; });
  EXPECT_GT(look_at(cup(26.0, 80.0, 1000), beyond).bounded, beyond.size() / 4);
}

// One might take the slope where the ray of x ends, and the gap there: next to a cliff that is far too much.
TEST(GapBracket, TheSlopeAtThePointAloneIsNoBound) {
  const auto cliff = [](const Vec3& u) { return u.x() > 0.0 ? 20.0 : 30.0; };
  const TriangleMesh body = radial_body(8000, cliff);
  const std::vector<Vec3> points{{-0.8, 3.0, 25.0}};
  const Found found = look_at(body, points);
  const double gap = 30.0 - points[0].norm();  // psi is 0 along the ray
  EXPECT_LT(found.distance[0], 0.5 * gap);
  EXPECT_LT(found.bracket[0].upper_mm, 0.5 * gap);
}

TEST(GapBracket, HoldsInTheCentreAndFarOff) {
  const Found found = look_at(octahedron(10.0), {{0, 0, 0}, {1e-9, 0, 0}, {500, 30, 20}});
  EXPECT_EQ(found.bracket[0].lower_mm, 0.0);
  EXPECT_GT(found.bracket[2].lower_mm, 200.0);
}

// Distances have the roundings of the surface's radii there, however short x is.
TEST(GapBracket, HoldsNextToTheCentre) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (std::size_t k = 0; k < random_cases(); k += 20) {
    const TriangleMesh mesh = test::soup(1 + k % 7, static_cast<unsigned>(k));
    std::vector<Vec3> points = test::random_directions(20, static_cast<unsigned>(k) + 1);
    for (Vec3& x : points) x *= std::pow(10.0, -14.0 * share(random));
    look_at(mesh, points);
  }
}

TEST(GapBracket, RefusesAMeshWithoutFaces) {
  EXPECT_THROW(GapBracket{TriangleMesh{}}, std::invalid_argument);
}

}  // namespace
}  // namespace impinge::lab
