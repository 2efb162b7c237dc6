// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle is the distance in exact arithmetic: lower <= d <= upper for any mesh and any point, and the
// ends are no farther apart than a thin face is high.
#include "contact/euclidean_distance.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/part_distance.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "reference/closest_point.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/random_cases.hpp"
#include "support/soup.hpp"

namespace impinge {
namespace {

// The widest bracket.
double widest(const TriangleMesh& mesh, const std::vector<Vec3>& points) {
  const std::vector<DistanceBracket> found = EuclideanDistance(mesh).at(points);
  const std::vector<double> exact = closest_distances(mesh, {.points = points});
  double most = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DistanceBracket& ends = found[i];
    EXPECT_LE(ends.lower_mm, exact[i]) << points[i].transpose();
    EXPECT_GE(ends.upper_mm, exact[i]) << points[i].transpose();
    most = std::max(most, ends.upper_mm - ends.lower_mm);
  }
  return most;
}

std::vector<Vec3> points_within(double length, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-length, length);
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = place(random);
    const double y = place(random);
    points.emplace_back(x, y, place(random));
  }
  return points;
}

TEST(TheoremDistance, IsExactForTrianglesAtRandom) {
  for (unsigned seed = 0; seed < random_cases() / 10; ++seed) {
    const TriangleMesh mesh = test::soup(1 + seed % 40, seed);
    std::vector<Vec3> points = points_within(80.0, 20, seed);
    for (const Face& face : mesh.faces) {  // on a face, a side and a corner, as doubles have them
      const Vec3 a = corner(mesh, face, 0);
      points.emplace_back((a + corner(mesh, face, 1) + corner(mesh, face, 2)) / 3.0);
      points.emplace_back(0.5 * (a + corner(mesh, face, 1)));
      points.push_back(a);
    }
    EXPECT_LT(widest(mesh, points), 1e-6);
  }
}

TEST(EuclideanDistance, IsExactForThePair) {
  const BallSocketPair pair = make_ball_socket_pair(600, impinging_cam());
  EXPECT_LT(widest(pair.socket, pair.ball.vertices), 1e-9);
  EXPECT_LT(widest(pair.ball, pair.socket.vertices), 1e-9);
}

// Slivers of any width down to none, all over one another, and points above them: no normal is certain.
TEST(TheoremDistance, HoldsForSlivers) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (unsigned seed = 0; seed < random_cases() / 10; ++seed) {
    TriangleMesh mesh = test::soup(6, seed);
    for (std::size_t f = 0; f < 6; ++f) {
      const Vec3& a = mesh.vertices[3 * f];
      const Vec3& b = mesh.vertices[3 * f + 1];
      Vec3& c = mesh.vertices[3 * f + 2];
      const double height = f == 0 ? 0.0 : std::pow(10.0, -9.0 + 8.0 * share(random));
      c = a + 0.5 * (1.0 + share(random)) * (b - a) + height * (c - a);
    }
    std::vector<Vec3> points = points_within(40.0, 20, seed);
    for (const Vec3& v : mesh.vertices) points.emplace_back(v + 1e-3 * share(random) * Vec3::Ones());
    EXPECT_LT(widest(mesh, points), 1e-5);
  }
}

// Points above the inside of thin faces, where the distance from the plane decides. But for the roundings of
// lengths the distance is not above the exact one.
TEST(TheoremDistance, OfAThinFaceIsNotAboveTheExactOne) {
  test::Dice dice(61);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 a = 20.0 * dice.direction();
    const Vec3 along = dice.between(1.0, 20.0) * dice.direction();
    const Vec3 across = along.cross(dice.direction()).normalized();
    const double height = dice.power(-7.0, -2.5);
    const TriangleMesh mesh{{a, a + along, a + dice.between(0.2, 0.8) * along + height * across},
                            {{0, 1, 2}}};
    const Vec3 inside = (mesh.vertices[0] + mesh.vertices[1] + 2.0 * mesh.vertices[2]) / 4.0;
    const Vec3 x = inside + dice.power(-2.0, 1.0) * height * along.cross(across).normalized();
    const TurnFace face = turn_face(mesh.vertices[0], mesh.vertices[1], mesh.vertices[2]);
    ASSERT_TRUE(face.thin);
    const double exact = closest_distances(mesh, {.points = {&x, 1}})[0];
    EXPECT_LE(least_distance(x, face), exact + 20.0 * 0x1p-53 * 40.0) << k;
    EXPECT_GE(least_distance(x, face), exact - 1.1 * height) << k;
  }
}

// Edges that cross above each other under small angles: the distance of any two of their points is no less.
TEST(TheoremDistance, OfNearlyParallelEdgesIsNotAboveTheExactOne) {
  using Long3 = Eigen::Matrix<long double, 3, 1>;
  test::Dice dice(62);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 along = dice.between(1.0, 20.0) * dice.direction();
    const Vec3 across = along.cross(dice.direction()).normalized();
    const double sine = dice.power(-8.0, 0.0);
    const Vec3 other = (along + sine * along.norm() * across) * dice.between(0.5, 1.0);
    const Vec3 a0 = 20.0 * dice.direction();
    const Vec3 b0 = a0 + dice.between(0.3, 0.7) * along - dice.between(0.3, 0.7) * other +
                    dice.power(-2.0, 1.0) * sine * along.cross(across).normalized();
    const Vec3 a1 = a0 + along;
    const Vec3 b1 = b0 + other;
    const Long3 a = a1.cast<long double>() - a0.cast<long double>();
    const Long3 b = b1.cast<long double>() - b0.cast<long double>();
    const Long3 from = b0.cast<long double>() - a0.cast<long double>();
    const Long3 normal = a.cross(b);
    const long double s = std::clamp(from.cross(b).dot(normal) / normal.squaredNorm(), 0.0L, 1.0L);
    const long double t = std::clamp(from.cross(a).dot(normal) / normal.squaredNorm(), 0.0L, 1.0L);
    const auto distance = static_cast<double>((from + t * b - s * a).norm());
    const double left = sine < 0.5 * kThin ? 20.0 : 24.0 / kThin;  // to the caller
    EXPECT_LE(least_distance_of_edges(a0, a1, b0, b1), distance + left * 0x1p-53 * 40.0) << sine;
  }
}

TEST(TheoremDistance, HoldsForAllLengthsThatTheLibraryTakes) {
  for (const double scale : {0x1p-94, 1e-9, 1e9, 0x1p95}) {
    TriangleMesh mesh = test::soup(20, 3);
    std::vector<Vec3> points = points_within(50.0, 50, 4);
    for (Vec3& v : mesh.vertices) v *= scale;
    for (Vec3& x : points) x *= scale;
    EXPECT_LT(widest(mesh, points), 1e-9 * scale);
  }
}

TEST(EuclideanDistance, NoFaceIsRefused) {
  EXPECT_THROW(EuclideanDistance(TriangleMesh{}), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
