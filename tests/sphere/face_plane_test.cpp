// SPDX-License-Identifier: GPL-3.0-or-later
// n = side (b - a) x (c - a), p = n . a, against integers of 128 bits; r(u) = p / (n . u) is off by
// 60 u (1 + tan psi) at most, however thin the face is.
#include "sphere/face_plane.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "sphere/triangle_cone.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

__extension__ using Integer = __int128;
using Integers = std::array<Integer, 3>;

// Corners whose coordinates are integers below 2^40.
struct Thin {
  std::array<Vec3, 3> corner;
  int side = 0;
};

Vec3 rounded(const Vec3& x) {
  return x.unaryExpr([](double value) { return std::round(value); });
}

// Of all shapes and places: edges from 2^5 to 2^39 long, heights from nothing to as much.
std::vector<Thin> thin_faces(std::size_t count) {
  std::mt19937_64 random(5);
  const auto power = [&](double from, double to) {
    return std::exp2(std::uniform_real_distribution<double>(from, to)(random));
  };
  std::vector<Thin> faces;
  const std::vector<Vec3> u = test::random_directions(3 * count, 7);
  for (std::size_t k = 0; faces.size() < count; k = (k + 1) % count) {
    const double length = power(5.0, 39.0);
    const Vec3 a = rounded(power(30.0, 39.0) * u[3 * k]);
    const Vec3 b = rounded(a + length * u[3 * k + 1]);
    const Vec3 foot = a + power(-3.0, 0.5) * (b - a);
    const Vec3 c = rounded(foot + power(-4.0, std::log2(length)) * u[3 * k + 2]);
    const int side = orientation(a, b, c);
    if (side != 0) faces.push_back({{a, b, c}, side});
  }
  return faces;
}

Integers as_integers(const Vec3& x) {
  return {static_cast<std::int64_t>(x[0]), static_cast<std::int64_t>(x[1]), static_cast<std::int64_t>(x[2])};
}

struct ExactPlane {
  explicit ExactPlane(const Thin& face) {
    const Integers a = as_integers(face.corner[0]);
    const Integers b = as_integers(face.corner[1]);
    const Integers c = as_integers(face.corner[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      normal[i] = face.side * ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]));
      offset += normal[i] * a[i];
    }
  }
  Integers normal{};
  Integer offset = 0;
};

// Is the double within 2^-53 of the integer, but for 2^-40 of that?
bool is_rounded_once(double value, Integer exact) {
  const Integer size = exact < 0 ? -exact : exact;
  const Integer off = static_cast<Integer>(value) - exact;
  return (off < 0 ? -off : off) <= (size >> 53) + (size >> 93);
}

TEST(FacePlane, OfExactSumsIsRoundedOnce) {
  for (const Thin& face : thin_faces(20000)) {
    const auto& [a, b, c] = face.corner;
    const FacePlane plane = exact_face_plane(a, b, c, face.side);
    const ExactPlane truth(face);
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_TRUE(is_rounded_once(plane.normal[static_cast<Eigen::Index>(i)], truth.normal[i]));
    ASSERT_TRUE(is_rounded_once(plane.offset, truth.offset));
    ASSERT_TRUE(plane.exact);
    ASSERT_EQ(plane.size, plane.normal.norm());
  }
}

// 60 as in stress/measure.hpp, of which 8 are for what is not asked here.
TEST(FacePlane, ARadiusIsOffByAFewRoundingsHoweverThinTheFaceIs) {
  std::size_t exact = 0;
  double largest = 0.0;
  for (const Thin& face : thin_faces(20000)) {
    const TriangleCone cone(face.corner[0], face.corner[1], face.corner[2]);
    const ExactPlane truth(face);
    const Vec3 u = (0.3 * face.corner[0] + 0.3 * face.corner[1] + 0.4 * face.corner[2]).normalized();
    long double along = 0.0L;
    long double length = 0.0L;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto n = static_cast<long double>(truth.normal[i]);
      along += n * static_cast<long double>(u[static_cast<Eigen::Index>(i)]);
      length += n * n;
    }
    const double secant = static_cast<double>(std::sqrt(length) / along);
    if (!(secant > 0.0 && secant < 1e12) || !cone.contains(u)) continue;
    const long double radius = static_cast<long double>(truth.offset) / along;
    const double off = std::abs(static_cast<double>((cone.radius(u) - radius) / radius));
    largest = std::max(largest, off / secant);
    exact += cone.plane().exact ? 1U : 0U;
  }
  EXPECT_LT(largest, 52.0 * 0x1p-53);
  EXPECT_GT(exact, 5000U);
}

TEST(FacePlane, OfAnOrdinaryFaceIsTheKernelsToTheBit) {
  const std::vector<Vec3> u = test::random_directions(6000, 9);
  for (std::size_t k = 0; k + 2 < u.size(); k += 3) {
    const Vec3 a = 20.0 * u[k];
    const Vec3 across = a.cross(u[k + 1]).normalized();
    const Vec3 b = a + across;
    const Vec3 c = a + 0.5 * across + u[k].cross(across) + 0.5 * u[k + 2];  // angles above 25 degrees
    const int side = orientation(a, b, c);
    const FacePlane plane = face_plane(a, b, c, side);
    ASSERT_FALSE(plane.exact);
    const Vec3 normal = face_normal<double>(a, b, c, side);
    ASSERT_EQ(plane.normal, normal);
    ASSERT_EQ(plane.offset, normal.dot(a));
  }
}

// A face before the centre, whose tilt is that of its farthest corner over its nearest point.
TEST(FacePlane, CountsTheDistancesOfAFace) {
  for (const double wide : {1.0, 10.0, 100.0, 1000.0}) {
    const std::array<Vec3, 3> x{Vec3(wide, 0, 1), Vec3(-wide, wide, 1), Vec3(-wide, -wide, 1)};
    const FacePlane plane = face_plane(x[0], x[1], x[2], orientation(x[0], x[1], x[2]));
    EXPECT_EQ(plane.exact, wide > 2.0) << wide;
  }
}

// A strip 1 mm wide whose far end passes the centre at 1 mm: t = 100, whichever side is named first.
TEST(FacePlane, CountsTheLongerSideOfAStrip) {
  const Vec3 a(100, 0, 1);
  const Vec3 near(100, 1, 1);
  const Vec3 far(-100, 1, 1);
  EXPECT_TRUE(face_plane(a, near, far, orientation(a, near, far)).exact);
  EXPECT_TRUE(face_plane(a, far, near, orientation(a, far, near)).exact);
}

}  // namespace
}  // namespace impinge
