// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of the tables, r = n.v0 / (n.u), in numbers of 24, 53, 64 and 200 bits. With e(p) its error in p
// bits against 200 bits,
//   e(24) / e(53) ~ 2^29,   e(53) / e(64) ~ 2^11,
// unless something in the kernel is less precise than its numbers: a stray float literal, an arccosine of
// doubles.
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <gtest/gtest.h>

#include "sphere/as_floats.hpp"
#include "sphere/direction.hpp"
#include "sphere/plane_radius.hpp"
#include "sphere/triangle_cone.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/precise_conchoid.hpp"

namespace impinge::lab {
namespace {

using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<61>,
                                              boost::multiprecision::et_off>;

// Coordinates that a float holds: what differs comes from arithmetic alone.
struct Question {
  std::array<Vec3, 3> corner;
  Vec3 u;  // well inside of the face
};

std::vector<Question> questions(std::size_t count) {
  std::mt19937_64 random(12);
  std::vector<Question> questions;
  while (questions.size() < count) {
    const Vec3 middle = 25.0 * uniform_direction(random);
    Question question;
    for (Vec3& corner : question.corner) corner = as_floats(middle + 4.0 * uniform_direction(random));
    const auto& [a, b, c] = question.corner;
    question.u = as_floats((0.3 * a + 0.45 * b + 0.25 * c).normalized());
    const TriangleCone cone(a, b, c);
    const bool fat = (b - a).cross(c - a).norm() > 0.6 * (b - a).norm() * (c - a).norm();
    if (fat && cone.side() != 0 && cone.largest_slope() < 1.5) questions.push_back(question);
  }
  return questions;
}

struct Kernel {
  template <class Number>
  static Number radius(const Question& question) {
    const auto [a, b, c] = std::array{Vec3Of<Number>(question.corner[0].cast<Number>()),
                                      Vec3Of<Number>(question.corner[1].cast<Number>()),
                                      Vec3Of<Number>(question.corner[2].cast<Number>())};
    const int side = orientation(question.corner[0], question.corner[1], question.corner[2]);
    const Vec3Of<Number> normal = face_normal<Number>(a, b, c, side);
    return plane_radius<Number>(normal, normal.dot(a), Number(30), question.u.cast<Number>());
  }
};

// Root of the mean square of |r - r_200| (cos psi) / r: errors over their condition.
template <class Number>
double error() {
  double sum = 0.0;
  const std::vector<Question> asked = questions(2000);
  for (const Question& question : asked) {
    const auto truth = Kernel::radius<Precise>(question);
    const auto off = static_cast<double>((Precise(Kernel::radius<Number>(question)) - truth) / truth);
    const auto& [a, b, c] = question.corner;
    const double share = off / (1.0 + TriangleCone(a, b, c).largest_slope());
    sum += share * share;
  }
  return std::sqrt(sum / static_cast<double>(asked.size()));
}

// The two steps of the levels, in bits.
std::array<double, 2> steps() {
  const double in_float = error<float>();
  const double in_double = error<double>();
  const double in_long_double = error<long double>();
  return {std::log2(in_float / in_double), std::log2(in_double / in_long_double)};
}

class PrecisionLevels : public testing::Test {
 protected:
  void SetUp() override {
    if (std::numeric_limits<long double>::digits != 64)
      GTEST_SKIP() << "long double is no third precision here";
  }
};

TEST_F(PrecisionLevels, ErrorsShrinkAsTheNumbersDo) {
  const auto found = steps();
  EXPECT_NEAR(found[0], 29.0, 1.0);
  EXPECT_NEAR(found[1], 11.0, 1.0);
  EXPECT_LT(error<double>(), 1.1 * 0x1p-53) << "0.56 was seen";
}

// 100 bits more change nothing, so that 200 are the truth.
TEST_F(PrecisionLevels, TwoHundredBitsAreEnough) {
  using Finer = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<91>,
                                              boost::multiprecision::et_off>;
  for (const Question& question : questions(50)) {
    const Finer finer = Kernel::radius<Finer>(question);
    EXPECT_LT(static_cast<double>(abs(Finer(Kernel::radius<Precise>(question)) - finer) / finer), 0x1p-180);
  }
}

TEST(PlaneRadius, IsTheKernelOfTheTables) {
  for (const Question& question : questions(2000)) {
    const auto& [a, b, c] = question.corner;
    EXPECT_EQ(Kernel::radius<double>(question), TriangleCone(a, b, c).radius(question.u));
  }
}

// The truth of the family `conchoid` against closed forms and against itself:
//   s(phi) = 4 a sin(phi / 2),  A(pi) = 32 pi a^2 / 5  at the cusp a = b;  ds / dphi = speed,  dA / dphi =
//   area rate.

double relative(const Precise& value, const Precise& truth) {
  return Precise(abs(value - truth) / truth).convert_to<double>();
}

TEST(PreciseConchoid, IsTheCardioidAtTheCusp) {
  const PreciseConchoid curve({20.0, 20.0});
  for (const double phi : {0.1, 1.0, 2.5, 3.1}) {
    EXPECT_LT(relative(curve.length(phi), 80 * sin(Precise(phi) / 2)), 1e-50);
    EXPECT_LT(relative(curve.radius(phi), 40 * cos(Precise(phi) / 2) * cos(Precise(phi) / 2)), 1e-50);
  }
  // The double kPi is 1e-16 short of the number, where the area no longer grows.
  EXPECT_LT(relative(curve.area(kPi), 32 * acos(Precise(-1)) * 400 / 5), 1e-45);
}

TEST(PreciseConchoid, LengthAndAreaGrowAsTheirRates) {
  constexpr double kStep = 0x1p-30;
  for (const ConchoidShape& shape :
       {ConchoidShape{}, ConchoidShape{17.8431, 17.843}, ConchoidShape{20.0, 1.0}}) {
    const PreciseConchoid curve(shape);
    for (const double phi : {0.5, 1.5, 2.5}) {
      const Precise length = (curve.length(phi + kStep) - curve.length(phi - kStep)) / (2 * kStep);
      const Precise area = (curve.area(phi + kStep) - curve.area(phi - kStep)) / (2 * kStep);
      EXPECT_LT(relative(length, curve.speed(phi)), 1e-16);
      EXPECT_LT(relative(area, curve.area_rate(phi)), 1e-16);
    }
  }
}

}  // namespace
}  // namespace impinge::lab
