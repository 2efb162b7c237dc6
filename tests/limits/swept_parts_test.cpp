// SPDX-License-Identifier: GPL-3.0-or-later
// No sampled angle before the one that is found has a pair of parts within the distance, by brute force, and
// that angle has one but for the steps of the search.
#include "limits/swept_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/triangle_distance.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using test::Dice;

constexpr std::size_t kParts = 2;
constexpr int kSamples = 30;          // of each kind
constexpr double kSearchStep = 3e-5;  // radians, more than the last step of the search
constexpr double kWholeTurn = 2.0 * kPi;

struct Within {
  double start;   // mm
  double growth;  // mm a radian
  double operator()(const AngleSpan& span) const { return start + growth * span.to; }
};

struct SweptCase {
  std::vector<TurnFace> turning;
  std::vector<TurnFace> resting;
  Within within;
  double arm = 0.0;  // mm, of the farthest corner that turns
};

Vec3 random_way(Dice& random, double length) { return random.rotation() * Vec3(0, 0, length); }

// A point as often as a triangle.
TurnFace random_part(Dice& random, const Vec3& middle) {
  const double size = random.between(0.0, 1.0) < 0.5 ? 0.0 : random.power(-2.0, 1.0);
  const auto corner = [&] { return Vec3(middle + random_way(random, size)); };
  TurnFace face = turn_face(corner(), corner(), corner());
  face.doubt = random.between(0.0, 0.1);
  return face;
}

// Parts at rest are about the threshold from where one that turns comes by: all at nearly one angle, which
// may be that of the start, so that some come first by little and some at the end of the turn.
SweptCase random_case(Dice& random) {
  SweptCase made;
  made.within = {random.power(-2.0, 0.3), random.between(0.0, 0.2)};
  const double about = random.between(0.0, 1.0) < 0.5 ? random.between(0.0, kWholeTurn) : 0.0;
  for (std::size_t k = 0; k < kParts; ++k) {
    const double arm = random.power(-1.0, 1.5);
    const Vec3 middle = turned(Vec3(arm, 0, random.between(-20.0, 20.0)), random.between(0.0, kWholeTurn));
    made.turning.push_back(random_part(random, middle));
    for (const Vec3& x : made.turning.back().corner) made.arm = std::max(made.arm, x.head<2>().norm());
    const Vec3 off = random_way(random, made.within.start * random.between(0.5, 1.5));
    made.resting.push_back(random_part(random, turned(middle, about - random.power(-4.0, 0.0)) + off));
  }
  return made;
}

// How much nearer than asked for the nearest pair is, mm.
double surplus(const SweptCase& given, double angle) {
  double most = -HUGE_VAL;
  for (const TurnFace& s : given.turning) {
    const auto& [a, b, c] = s.corner;
    const Triangle moved{turned(a, angle), turned(b, angle), turned(c, angle)};
    for (const TurnFace& t : given.resting)
      most = std::max(most, s.doubt + t.doubt - std::sqrt(squared_distance_of_triangles(moved, t.corner)));
  }
  return most + given.within({angle, angle});
}

// Everywhere before the angle, and next to it.
void expect_nothing_before(const SweptCase& given, double angle, Dice& random) {
  for (int k = 0; k < kSamples; ++k) {
    for (const double t : {random.between(0.0, 1.0) * angle, angle - random.power(-6.0, 0.0)}) {
      if (t < 0.0 || t >= angle) continue;
      ASSERT_LE(surplus(given, t), 1e-9) << t << " before " << angle;
    }
  }
}

TEST(SweptParts, AreFirstWithinWhereBruteForceHasThem) {
  Dice random(21);
  std::size_t met = 0;
  const std::size_t cases = random_cases();
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    const SweptCase given = random_case(random);
    const double largest = std::min(random.between(0.0, 2.0 * kWholeTurn), kWholeTurn);
    const SweptParts turning(given.turning);
    const SweptParts resting(given.resting);
    const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
    const double first = first_within({turning, upright, resting, upright}, given.within, largest);
    expect_nothing_before(given, first, random);
    if (first == largest) continue;
    met += first > 0.0 ? 1 : 0;
    ASSERT_GE(surplus(given, first), -kSearchStep * (given.arm + given.within.growth)) << k;
  }
  EXPECT_GT(met, cases / 4);
}

}  // namespace
}  // namespace impinge
