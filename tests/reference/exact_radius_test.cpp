// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle of the oracle: every face, in numbers of more than 200 bits, rounded once. The reference must
// give the same double, bit for bit:
//   r = t |u|,  t u on a face,  the nearest or the farthest.
#include "reference/exact_radius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/exact_ratio.hpp"
#include "support/bits.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/precise.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

using test::bits;
using test::Precise;

// Same double, or no surface in both.
void expect_same(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(std::isnan(found[i]), std::isnan(expected[i])) << i;
    if (std::isnan(found[i])) continue;
    ASSERT_EQ(bits(found[i]), bits(expected[i])) << i << ": " << found[i];
  }
}

std::vector<double> precise_radii(const TriangleMesh& mesh, const std::vector<Vec3>& directions,
                                  Layer layer) {
  std::vector<double> radii;
  for (const Vec3& u : directions) radii.push_back(test::precise_radius(mesh, u, layer));
  return radii;
}

// |u|_2 / |u|_1 R, for vectors of any length and the poles, axes and seams of all schemes.
TEST(ExactRadius, OctahedronIsTheClosedForm) {
  std::vector<Vec3> directions = test::special_directions();
  for (const Vec3& u : test::random_directions(500, 1)) directions.push_back(1e3 * u);
  const std::vector<double> radii = exact_radii(octahedron(22.0), {.directions = directions});
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const test::PreciseVec u = test::precise(directions[i]);
    const Precise radius = 22 * sqrt(test::dot(u, u)) / (abs(u[0]) + abs(u[1]) + abs(u[2]));
    EXPECT_EQ(bits(radii[i]), bits(radius.convert_to<double>())) << i;
  }
}

TEST(ExactRadius, LastBitIsThatOfTwoHundredBitsInTenThousandCases) {
  const TriangleMesh ball = make_ball_socket_pair(8).ball;
  const std::vector<Vec3> directions = test::random_directions(10000, 2);
  expect_same(exact_radii(ball, {.directions = directions}), precise_radii(ball, directions, Layer::nearest));
}

// At vertices and on edges, where several faces share the ray, and beyond the rim.
TEST(ExactRadius, FeaturesOfAnOpenSocketAreThoseOfBruteForce) {
  const TriangleMesh socket = test::moved(make_ball_socket_pair(60).socket, {1.25, -0.5, 3.0});
  std::vector<Vec3> directions = test::feature_directions(socket);
  for (const Vec3& v : socket.vertices) directions.push_back(v);  // exactly through it
  for (const Vec3& u : test::random_directions(300, 3)) directions.push_back(u);
  const std::vector<double> expected = precise_radii(socket, directions, Layer::nearest);
  EXPECT_GT(std::ranges::count_if(expected, [](double r) { return std::isnan(r); }), 50);
  expect_same(exact_radii(socket, {.directions = directions}), expected);
}

TEST(ExactRadius, BothLayersOfASoupAreThoseOfBruteForce) {
  const TriangleMesh mesh = test::soup(40, 4);
  std::vector<Vec3> directions = test::random_directions(200, 5);
  for (const Vec3& v : mesh.vertices) directions.push_back(v);
  for (const Layer layer : {Layer::nearest, Layer::farthest}) {
    expect_same(exact_radii(mesh, {.directions = directions, .layer = layer}),
                precise_radii(mesh, directions, layer));
  }
}

// Faces larger than a hemisphere's share, and needles that the centre sees almost edge-on.
TEST(ExactRadius, HugeAndGrazingFacesAreThoseOfBruteForce) {
  TriangleMesh mesh;
  mesh.vertices = {{900, 0, 1},    {-500, 800, 1}, {-500, -800, 1},
                   {10, 0, 2e-13}, {20, 1e-9, 0},  {15, 3, -1e-13}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  std::vector<Vec3> directions = test::random_directions(500, 6);
  for (double share = 0.0; share <= 1.0; share += 0.125) {
    const Vec3 edge = mesh.vertices[3] + share * (mesh.vertices[4] - mesh.vertices[3]);
    directions.push_back(edge + 0.3 * (mesh.vertices[5] - edge));
  }
  expect_same(exact_radii(mesh, {.directions = directions}), precise_radii(mesh, directions, Layer::nearest));
}

TEST(ExactRadius, EdgeOnFacesCoverNoDirection) {
  TriangleMesh mesh = octahedron(10.0);
  test::add_face(mesh, {2, 0, 0}, {4, 0, 0}, {3, 1, 0});
  const std::vector<Vec3> directions{{3, 0.25, 0}, {1, 0, 0}};
  EXPECT_EQ(exact_radii(mesh, {.directions = directions})[1], 10.0);
  expect_same(exact_radii(mesh, {.directions = directions}),
              exact_radii(octahedron(10.0), {.directions = directions}));
}

// The ray caster and the reference share nothing; the ray caster is in error by a few units in the last
// place.
TEST(ExactRadius, TheRayCasterIsWithinRounding) {
  const TriangleMesh ball = make_ball_socket_pair(2000).ball;
  const RayCaster caster(ball);
  const std::vector<Vec3> directions = test::random_directions(5000, 7);
  std::size_t reported = 0;
  const std::vector<double> radii =
      exact_radii(ball, {.directions = directions, .progress = [&](std::size_t done) { reported = done; }});
  EXPECT_EQ(reported, directions.size());
  for (std::size_t i = 0; i < radii.size(); ++i)
    ASSERT_NEAR(caster.cast(directions[i], Layer::nearest), radii[i], 1e-13 * radii[i]);
}

// Roots half-way between two doubles go to the even one, and the least excess decides.
TEST(NearestRoot, TiesGoToTheEvenDouble) {
  const ExactNumber one(1.0);
  const ExactNumber tie = ExactNumber(0x1p53) + one;
  EXPECT_EQ(nearest_root({tie * tie, one}), 0x1p53);
  EXPECT_EQ(nearest_root({tie * tie + one, one}), 0x1p53 + 2.0);
  const ExactNumber odd_tie = ExactNumber(0x1p53) + ExactNumber(3.0);
  EXPECT_EQ(nearest_root({odd_tie * odd_tie, one}), 0x1p53 + 4.0);
  EXPECT_EQ(nearest_root({odd_tie * odd_tie - one, one}), 0x1p53 + 2.0);
}

TEST(NearestRoot, HoldsOverTheRangeOfDoubles) {
  for (const double x : {1.0, 0.1, 3.0, 1e-150, 7e150, 0x1p-500, 0x1.fffffffffffffp400}) {
    EXPECT_EQ(nearest_root({ExactNumber(x) * ExactNumber(x), ExactNumber(1.0)}), x);
    EXPECT_EQ(nearest_root({ExactNumber(1.0), ExactNumber(4.0)}), 0.5);
    EXPECT_EQ(nearest_root({ExactNumber(x), ExactNumber(1.0)}), std::sqrt(x)) << "IEEE 754 rounds it so";
    EXPECT_EQ(nearest_root({ExactNumber(0.0), ExactNumber(x)}), 0.0);
  }
}

TEST(ExactRadius, RefusesWhatHasNoDistance) {
  const TriangleMesh good = octahedron(10.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> zero{{0, 0, 1}, {0, 0, 0}};
  const std::vector<Vec3> broken{{0, 0, nan}};
  EXPECT_THROW(exact_radii(good, {.directions = zero}), std::invalid_argument);
  EXPECT_THROW(exact_radii(good, {.directions = broken}), std::invalid_argument);
  EXPECT_THROW(exact_radii({}, {.directions = {}}), std::invalid_argument);
  TriangleMesh bad = good;
  bad.faces[0][1] = 99;
  EXPECT_THROW(exact_radii(bad, {.directions = {}}), std::invalid_argument);
  bad = good;
  bad.vertices[2].x() = nan;
  EXPECT_THROW(exact_radii(bad, {.directions = {}}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
