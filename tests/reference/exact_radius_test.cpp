// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle of the oracle: every face, in numbers of more than 200 bits, rounded once. The reference must
// give the same double, bit for bit:
//   r = t |u|,  t u on a face,  the nearest or the farthest.
#include "reference/exact_radius.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include <boost/multiprecision/mpfr.hpp>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reference/closest_point.hpp"
#include "reference/exact_ratio.hpp"
#include "reference/shadow.hpp"
#include "sphere/radial_table.hpp"
#include "support/bits.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"
#include "table/layer.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace test {

// Distances to a mesh by brute force in numbers of more than 200 bits (MPFR), rounded to double once.
//
// A determinant of three vectors of doubles needs 159 bits and a few more where their exponents differ: with
// coordinates of one scale its sign is that of the exact value.

using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<75>,
                                              boost::multiprecision::et_off>;
using PreciseVec = std::array<Precise, 3>;

inline PreciseVec precise(const Vec3& x) { return {Precise(x.x()), Precise(x.y()), Precise(x.z())}; }

inline PreciseVec minus(const PreciseVec& a, const PreciseVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline PreciseVec cross(const PreciseVec& a, const PreciseVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Precise dot(const PreciseVec& a, const PreciseVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Precise det(const PreciseVec& a, const PreciseVec& b, const PreciseVec& c) {
  return dot(a, cross(b, c));
}

// t with t u on the closed face, by Cramer's rule: u = sum of w_k times corner k, t = 1 / (w_0 + w_1 + w_2).
inline std::optional<Precise> place_on_face(const TriangleMesh& mesh, const Face& face, const Vec3& u) {
  const PreciseVec a = precise(corner(mesh, face, 0));
  const PreciseVec b = precise(corner(mesh, face, 1));
  const PreciseVec c = precise(corner(mesh, face, 2));
  const PreciseVec d = precise(u);
  const Precise whole = det(a, b, c);
  if (whole == 0) return std::nullopt;
  const std::array<Precise, 3> weight{det(d, b, c) / whole, det(a, d, c) / whole, det(a, b, d) / whole};
  for (const Precise& w : weight) {
    if (w < 0) return std::nullopt;
  }
  return 1 / (weight[0] + weight[1] + weight[2]);
}

inline double precise_radius(const TriangleMesh& mesh, const Vec3& u, Layer layer) {
  std::optional<Precise> kept;
  for (const Face& face : mesh.faces) {
    const auto t = place_on_face(mesh, face, u);
    if (!t) continue;
    if (!kept || (layer == Layer::nearest ? *t < *kept : *t > *kept)) kept = t;
  }
  if (!kept) return kNoSurface;
  return Precise(*kept * sqrt(dot(precise(u), precise(u)))).convert_to<double>();
}

// Squared distance from a segment: the foot on the line, held between the ends.
inline Precise squared_distance(const PreciseVec& x, const PreciseVec& from, const PreciseVec& to) {
  const PreciseVec e = minus(to, from);
  const Precise length = dot(e, e);
  Precise share = length == 0 ? Precise(0) : Precise(dot(e, minus(x, from)) / length);
  if (share < 0) share = 0;
  if (share > 1) share = 1;
  const PreciseVec foot{from[0] + share * e[0], from[1] + share * e[1], from[2] + share * e[2]};
  return dot(minus(x, foot), minus(x, foot));
}

// Squared distance from a face: that of the nearest side, or of the plane if the foot on it has three weights
// above zero.
inline Precise squared_distance(const PreciseVec& x, const std::array<PreciseVec, 3>& c) {
  Precise least = squared_distance(x, c[0], c[1]);
  for (std::size_t k = 1; k < 3; ++k) {
    const Precise side = squared_distance(x, c[k], c[(k + 1) % 3]);
    if (side < least) least = side;
  }
  const PreciseVec n = cross(minus(c[1], c[0]), minus(c[2], c[0]));
  const Precise area = dot(n, n);
  for (std::size_t k = 0; k < 3; ++k) {
    const PreciseVec across = cross(minus(c[(k + 1) % 3], c[k]), minus(x, c[k]));
    if (dot(across, n) <= 0) return least;
  }
  const Precise height = dot(n, minus(x, c[0]));
  return height * height / area;
}

inline double precise_distance(const TriangleMesh& mesh, const Vec3& x) {
  std::optional<Precise> least;
  for (const Face& face : mesh.faces) {
    const Precise here = squared_distance(
        precise(x),
        {precise(corner(mesh, face, 0)), precise(corner(mesh, face, 1)), precise(corner(mesh, face, 2))});
    if (!least || here < *least) least = here;
  }
  return Precise(sqrt(*least)).convert_to<double>();
}

}  // namespace test

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

// The oracle of the oracle: every face, in numbers of more than 200 bits, rounded once. The reference must
// give the same double, bit for bit:
//   d(x) = min over the points y of all faces of |x - y|

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

// Shadow of Y = {s y : y in Y, s >= 1}, in closed form and against points of it.

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
