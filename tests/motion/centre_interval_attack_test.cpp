// SPDX-License-Identifier: GPL-3.0-or-later
// The interval of a limit holds for random centres within the distance, on its sphere and inside: about each
// of them no pose up to the lower end is impinged, and the pose at the upper end is.
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "motion/turn_limit.hpp"
#include "motion/turn_oracle.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using test::Dice;

constexpr int kCentres = 4;

struct CentreCase {
  BallSocketPair joint;
  JointTurn motion;
  CentreQuestion question;
};

struct CentreCounts {
  std::size_t limited = 0;  // at the origin
  std::size_t bounded = 0;  // with a proven upper end
  std::size_t lower = 0;    // with a lower end above 0
};

test::OracleCentre centre_within(const CentreQuestion& question, Dice& random) {
  const double length =
      question.within_mm * (random.between(0.0, 1.0) < 0.7 ? 1.0 : random.between(0.0, 1.0));
  const Vec3 by = random.rotation() * Vec3(0, 0, 0.999999 * length);
  return question.doubt == CentreDoubt::common ? test::OracleCentre{by, Vec3::Zero()}
                                               : test::OracleCentre{Vec3::Zero(), by};
}

// Before a turn the inner and the outer rotation move what the oracle knows as the joint at rest.
void check_interval(const CentreCase& given, Dice& random, std::size_t number, CentreCounts& counts) {
  const TurnLimits limits(given.joint);
  const TurnLimit limit = limits.first_contact(given.motion, given.question.largest_deg);
  if (limit.state == LimitState::blocked) return;
  const CentreInterval interval = limits.centre_interval(given.motion, limit, given.question);
  ASSERT_LE(interval.low_deg, limit.low_deg + 1e-9) << number;
  ASSERT_GE(interval.high_deg, limit.high_deg - 1e-9) << number;
  counts.limited += limit.state == LimitState::limited ? 1 : 0;
  counts.bounded += interval.limited ? 1 : 0;
  counts.lower += interval.low_deg > 0.0 ? 1 : 0;
  for (int k = 0; k < kCentres; ++k) {
    const test::TurnOracle oracle(given.joint, given.motion.axis, centre_within(given.question, random));
    for (const double share : {1.0, random.between(0.9, 1.0), random.between(0.0, 1.0)})
      ASSERT_FALSE(interval.low_deg > 0.0 && oracle.surely_impinged(share * interval.low_deg)) << number;
    if (interval.limited) {
      ASSERT_TRUE(oracle.perhaps_impinged(interval.high_deg)) << number;
    }
  }
}

CentreQuestion random_question(CentreDoubt doubt, Dice& random) {
  CentreQuestion question;
  question.doubt = doubt;
  question.within_mm = random.power(-2.0, 0.3);
  question.largest_deg = 170.0;
  return question;
}

// Of each question half of the cases.
class CentreIntervalAttack : public testing::TestWithParam<CentreDoubt> {};

INSTANTIATE_TEST_SUITE_P(Doubts, CentreIntervalAttack,
                         testing::Values(CentreDoubt::common, CentreDoubt::play),
                         [](const auto& of) { return of.param == CentreDoubt::common ? "Common" : "Play"; });

TEST_P(CentreIntervalAttack, OfLooseTriangles) {
  Dice random(11);
  CentreCounts counts;
  const std::size_t cases = random_cases() / 2;
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    CentreCase given;
    for (int f = 0; f < 2; ++f) {
      for (TriangleMesh* mesh : {&given.joint.ball, &given.joint.socket}) {
        const Vec3 middle = random.rotation() * Vec3(0, 0, random.between(4.0, 25.0));
        const double size = random.power(0.0, 1.2);
        const auto corner = [&] { return Vec3(middle + random.rotation() * Vec3(0, 0, size)); };
        test::add_face(*mesh, corner(), corner(), corner());
      }
    }
    given.motion.axis = random.rotation() * Vec3::UnitX();
    given.question = random_question(GetParam(), random);
    check_interval(given, random, k, counts);
  }
  EXPECT_GT(counts.limited, cases / 10);
  EXPECT_GT(counts.lower, cases / 4);
}

// A ball with a spike below a roof of four faces: the spike turns into the roof, or behind its rim.
TEST_P(CentreIntervalAttack, OfASpikeBelowARoof) {
  Dice random(12);
  CentreCounts counts;
  const std::size_t cases = random_cases() / 2;
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    CentreCase given{{octahedron(10.0), octahedron(26.0)}, {}, random_question(GetParam(), random)};
    given.joint.ball.vertices[1] *= random.between(1.2, 3.5);
    std::erase_if(given.joint.socket.faces, [&](const Face& face) {
      Vec3 middle = Vec3::Zero();
      for (const VertexIndex v : face) middle += given.joint.socket.vertices[v];
      return middle.z() < 0.0;
    });
    const Eigen::Matrix3d before = random.rotation();
    for (Vec3& x : given.joint.ball.vertices) x = before * x;
    for (Vec3& x : given.joint.socket.vertices) x *= random.between(0.8, 1.2);
    given.motion.axis = random.rotation() * Vec3::UnitX();
    check_interval(given, random, k, counts);
  }
  EXPECT_GT(counts.limited, cases / 10);
  EXPECT_GT(counts.bounded, cases / 20);
  EXPECT_GT(counts.lower, cases / 10);
}

}  // namespace
}  // namespace impinge
