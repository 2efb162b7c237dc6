// SPDX-License-Identifier: GPL-3.0-or-later
// What the Gappa scripts of the library prove, held against long double in random cases: no error is above
// what is proven. The largest, in the unit of the bound, is the property `largest` of each test, and `seen`
// in the script.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "contact/cap_lanes.hpp"
#include "contact/part_distance.hpp"
#include "files/formatted.hpp"
#include "limits/sinusoid.hpp"
#include "sphere/face_plane.hpp"
#include "sphere/haversine.hpp"
#include "sphere/triangle_cone.hpp"
#include "sphere/turn_angle.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using Long = long double;
__extension__ using Quad = __float128;
using LongVec = Eigen::Matrix<Long, 3, 1>;
constexpr Long kUnit = 0x1p-53L;
constexpr Long kFloatUnit = 0x1p-24L;
constexpr Long kLongPi = std::numbers::pi_v<Long>;

LongVec in_long(const Vec3& x) { return x.cast<Long>(); }

// Tries random cases; error(dice) is that of one in units of what it is a share of.
template <class Error>
void expect_within(Long proven, const Error& error) {
  test::Dice dice(54);
  Long largest = 0.0L;
  for (std::size_t k = 0; k < random_cases(); ++k) largest = std::max(largest, error(dice));
  EXPECT_LE(largest, proven);
  testing::Test::RecordProperty("largest", formatted("%.2Lg", largest));
}

// Vectors of all lengths, and often nearly in one plane with others.
Vec3 any_vector(test::Dice& dice) { return dice.power(-3.0, 3.0) * dice.direction(); }
std::array<Vec3, 3> any_three(test::Dice& dice) {
  const Vec3 a = any_vector(dice);
  const Vec3 b = any_vector(dice);
  return {
      a, b,
      dice.between(-2.0, 2.0) * a + dice.between(-2.0, 2.0) * b + dice.power(-16.0, 1.0) * any_vector(dice)};
}

TEST(Rounding, OfADeterminant) {
  expect_within(5.01L, [](test::Dice& dice) {
    const auto [a, b, c] = any_three(dice);
    const Long size = a.lpNorm<1>() * b.lpNorm<1>() * c.lpNorm<1>();
    return std::abs(a.dot(b.cross(c)) - in_long(a).dot(in_long(b).cross(in_long(c)))) / size / kUnit;
  });
}

TEST(Rounding, OfAPlaneSide) {
  expect_within(8.01L, [](test::Dice& dice) {
    const Vec3 at = any_vector(dice);
    auto [b, c, d] = any_three(dice);
    for (Vec3* x : {&b, &c, &d}) *x += at;
    const Vec3 ab = b - at;
    const Vec3 ac = c - at;
    const Vec3 ad = d - at;
    const LongVec p = in_long(b) - in_long(at);
    const LongVec q = in_long(c) - in_long(at);
    const LongVec r = in_long(d) - in_long(at);
    const Long size = ab.lpNorm<1>() * ac.lpNorm<1>() * ad.lpNorm<1>();
    return std::abs(ab.dot(ac.cross(ad)) - p.dot(q.cross(r))) / size / kUnit;
  });
}

TEST(Rounding, OfAHaversine) {  // in 1e-16
  expect_within(7.0L, [](test::Dice& dice) {
    const double angle = dice.between(0.0, kPi);
    const Long sine = std::sin(0.5L * static_cast<Long>(angle));
    const Long exact = sine * sine;
    return std::abs(haversine(angle) - exact) / (angle < 0.5 * kPi ? exact : 1.0L) / 1e-16L;
  });
}

TEST(Rounding, OfATurnAngle) {  // in 1e-16
  expect_within(3.0L, [](test::Dice& dice) {
    const double turns = dice.between(0.0, 100.0);
    const Long angle = 2.0L * kLongPi * (static_cast<Long>(turns) - std::floor(static_cast<Long>(turns)));
    const CosSin found = turn_angle(turns);
    return std::max(std::abs(found.cos - std::cos(angle)), std::abs(found.sin - std::sin(angle))) / 1e-16L;
  });
}

// A face and a direction within it.
struct SeenFace {
  std::array<Vec3, 3> corner;
  Vec3 u;
  explicit SeenFace(test::Dice& dice) : corner(any_three(dice)) {
    u = (dice.between(0.1, 1.0) * corner[0] + dice.between(0.1, 1.0) * corner[1] +
         dice.between(0.1, 1.0) * corner[2])
            .stableNormalized();
  }
  // a . (b x c), from numbers of 113 bits: of a thin face little is left of those of a long double.
  static Quad determinant(const std::array<Quad, 3>& a, const std::array<Quad, 3>& b,
                          const std::array<Quad, 3>& c) {
    Quad sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      sum += a[i] * (b[j] * c[k] - b[k] * c[j]);
    }
    return sum;
  }
  static std::array<Quad, 3> in_quad(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
  static std::array<Quad, 3> difference(const Vec3& to, const Vec3& from) {
    std::array<Quad, 3> d = in_quad(to);
    for (std::size_t i = 0; i < 3; ++i) d[i] -= from[static_cast<Eigen::Index>(i)];
    return d;
  }
  LongVec normal() const {
    const auto p = difference(corner[1], corner[0]);
    const auto q = difference(corner[2], corner[0]);
    const auto part = [&](std::size_t j, std::size_t k) {
      return static_cast<Long>(p[j] * q[k] - p[k] * q[j]);
    };
    return {part(1, 2), part(2, 0), part(0, 1)};
  }
  Long offset() const {
    return static_cast<Long>(determinant(in_quad(corner[0]), in_quad(corner[1]), in_quad(corner[2])));
  }
  Long radius() const {
    const Quad along =
        determinant(in_quad(u), difference(corner[1], corner[0]), difference(corner[2], corner[0]));
    const Quad of = determinant(in_quad(corner[0]), in_quad(corner[1]), in_quad(corner[2]));
    return std::abs(static_cast<Long>(of / along) * in_long(u).norm());
  }
};

// 1 / cos psi is at most 1e10, so that long double has digits left.
TEST(Rounding, OfARadius) {
  expect_within(60.0L, [](test::Dice& dice) {
    const SeenFace face(dice);
    const Long radius = face.radius();
    const Long steep = face.normal().norm() * radius / std::abs(face.offset());
    if (!(steep < 1e10L)) return 0.0L;
    const TriangleCone cone(face.corner[0], face.corner[1], face.corner[2]);
    if (std::isinf(cone.largest_slope())) return 0.0L;  // no digit is certain: the radius of a corner
    return std::abs(cone.radius(face.u) - radius) / (radius * steep * kUnit);
  });
}

TEST(Rounding, OfAnAngleBetween) {
  expect_within(13.0L, [](test::Dice& dice) {
    const Vec3 a = any_vector(dice);
    const Vec3 b = dice.between(-1.0, 1.0) * a + dice.power(-16.0, 1.0) * any_vector(dice);
    const Long exact = std::atan2(in_long(a).cross(in_long(b)).norm(), in_long(a).dot(in_long(b)));
    return std::abs(angle_between(a, b) - exact) / kUnit;
  });
}

TEST(Rounding, OfTheDistanceFromAPlane) {
  expect_within(21.0L, [](test::Dice& dice) {
    const Vec3 a = any_vector(dice);
    const Vec3 b = any_vector(dice);
    const Vec3 c =
        a + dice.between(0.0, 1.0) * (b - a) + dice.power(-2.0, 0.0) * (b - a).norm() * dice.direction();
    const TurnFace face = turn_face(a, b, c);
    const LongVec normal = (in_long(b) - in_long(a)).cross(in_long(c) - in_long(a));
    const Long sine = normal.norm() / static_cast<Long>(face.size);
    if (face.thin || !(sine > 0.0L)) return 0.0L;
    const Vec3 foot = (a + b + c) / 3.0;
    const Vec3 x = foot + dice.power(-6.0, 0.0) * (b - a).norm() * face.normal.normalized();
    const Long exact = std::abs(normal.dot(in_long(x) - in_long(a))) / normal.norm();
    return std::abs(least_distance(x, face) - exact) / ((in_long(x) - in_long(a)).norm() / sine * kUnit);
  });
}

TEST(Rounding, OfATurnedVertex) {
  expect_within(20.0L, [](test::Dice& dice) {
    const Vec3 x = any_vector(dice);
    const double angle = dice.between(0.0, 2.0 * kPi);
    const Long c = std::cos(static_cast<Long>(angle));
    const Long s = std::sin(static_cast<Long>(angle));
    const LongVec from = in_long(x);
    const LongVec exact(c * from.x() - s * from.y(), s * from.x() + c * from.y(), from.z());
    return (in_long(turned(x, angle)) - exact).norm() / (from.norm() * kUnit);
  });
}

// A span of the angles in which a sinusoid is within a bound begins no later, and ends no earlier, than the
// true one.
TEST(Rounding, OfTheEndsOfASpan) {
  expect_within(0.0L, [](test::Dice& dice) {
    const Sinusoid f{dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-0.5, 0.5)};
    const AngleSpans spans = near_zero(f, 1e-3);
    const Long t = 2.0L * kLongPi * dice.between(0.0, 1.0);
    const Long value = f.cosine * std::cos(t) + f.sine * std::sin(t) + f.constant;
    const bool held =
        std::ranges::any_of(spans, [t](const AngleSpan& s) { return s.from <= t && t <= s.to; });
    return std::abs(value) > 1e-3L || held ? 0.0L : 1.0L;
  });
}

// |s w + o| of the axis itself, an angle of 0: what rounding takes of the slack.
template <Surface kScanned>
Long length_error(test::Dice& dice) {
  const Vec3 axis = dice.direction();
  const Pose pose{
      Eigen::Matrix3d::Identity(),
      dice.power(-2.0, 1.0) * (dice.between(-1.0, 1.0) * axis + dice.power(-6.0, 0.0) * dice.direction())};
  CapBlock block{};
  block.x.fill(static_cast<float>(axis.x()));
  block.y.fill(static_cast<float>(axis.y()));
  block.z.fill(static_cast<float>(axis.z()));
  block.low.fill(1.0F);
  block.high.fill(1.0F);
  const CapMove move(kScanned, pose);
  const Long squared =
      in_long(axis + (kScanned == Surface::ball ? 1.0 : -1.0) * pose.translation).squaredNorm();
  const Long found = lanes::length_of<kScanned>(block, move, 0);
  const Long size = 1.0L + in_long(pose.translation).squaredNorm();
  const Long slack = static_cast<Long>(kSquareSlack) * size;
  if (found == 0.0L) return 0.0L;  // cut off there
  return (kScanned == Surface::ball ? squared + slack - found * found : found * found - squared + slack) /
         size / kFloatUnit;
}

TEST(Rounding, OfAMovedLength) {
  expect_within(33.0L, [](test::Dice& dice) {
    return std::max(length_error<Surface::ball>(dice), length_error<Surface::socket>(dice));
  });
}

}  // namespace
}  // namespace impinge
