// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle of the oracle: every face, in numbers of more than 200 bits, rounded once. The reference must
// give the same double, bit for bit:
//   d(x) = min over the points y of all faces of |x - y|
#include "reference/closest_point.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/bits.hpp"
#include "support/directions.hpp"
#include "support/precise.hpp"

namespace impinge {
namespace {

using test::bits;

void expect_brute_force(const TriangleMesh& mesh, const std::vector<Vec3>& points) {
  const std::vector<double> distances = closest_distances(mesh, {.points = points});
  ASSERT_EQ(distances.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ(bits(distances[i]), bits(test::precise_distance(mesh, points[i]))) << i << ": " << distances[i];
}

// Points at all distances from the surface, inside and outside.
std::vector<Vec3> points_round(double radius, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 2.0);
  std::vector<Vec3> points = test::random_directions(count, seed + 1);
  for (Vec3& x : points) x *= radius * share(random);
  return points;
}

TEST(ClosestPoint, OctahedronIsTheClosedForm) {
  const std::vector<Vec3> points{{0, 0, 0},  {30, 0, 0}, {1, 1, 1},   {20, 20, 20},
                                 {0, 0, 12}, {6, 6, 0},  {6, 6, -0.0}};
  const std::vector<double> distances = closest_distances(octahedron(12.0), {.points = points});
  EXPECT_EQ(distances[0], std::sqrt(48.0));
  EXPECT_EQ(distances[1], 18.0);
  EXPECT_EQ(distances[2], std::sqrt(27.0));
  EXPECT_EQ(distances[3], std::sqrt(768.0));
  for (const std::size_t on : {4U, 5U, 6U}) EXPECT_EQ(distances[on], 0.0);
}

TEST(ClosestPoint, LastBitIsThatOfTwoHundredBitsInTenThousandCases) {
  TriangleMesh half = octahedron(22.0);
  half.faces.resize(4);
  expect_brute_force(half, points_round(22.0, 10000, 1));
}

TEST(ClosestPoint, PairIsThatOfBruteForce) {
  const BallSocketPair pair = make_ball_socket_pair(60);
  expect_brute_force(pair.socket, points_round(26.0, 200, 2));
  expect_brute_force(pair.socket, pair.ball.vertices);
  expect_brute_force(pair.ball, pair.ball.vertices);  // all on it
}

// Needles, on which a foot computed in double is far from the face, and faces without any area.
TEST(ClosestPoint, NeedlesAndFacesWithoutAreaAreThoseOfBruteForce) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 1e-9, 3}, {20, 0, 6}, {5, 5, 5}, {7, 7, 7}, {9, 9, 9}, {-4, 0, 1}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}, {6, 6, 6}};
  expect_brute_force(mesh, points_round(12.0, 200, 3));
  mesh.faces = {{3, 4, 5}};
  expect_brute_force(mesh, points_round(12.0, 50, 4));
}

TEST(ClosestPoint, RefusesWhatHasNoDistance) {
  const std::vector<Vec3> broken{{0, std::numeric_limits<double>::infinity(), 0}};
  EXPECT_THROW(closest_distances(octahedron(10.0), {.points = broken}), std::invalid_argument);
  EXPECT_THROW(closest_distances({}, {.points = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
