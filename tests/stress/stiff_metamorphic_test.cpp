// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change, or change by a known factor, in what the kernels and the culled answers say:
//   units of a power of two    the same digits, bit for bit, or a refusal of one line
//   a pose without rounding    what the moved points give, bit for bit, whatever the translation
//   the order of faces         the same bits; of vertices, the same bits in that order
//   threads that share tables  the same bits
#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "stress/stiff_answers.hpp"
#include "support/bits.hpp"

namespace impinge::lab {
namespace {

using test::Answerer;
using test::Answers;
using test::Questions;

// Bit for bit, all NaN alike, in units of `unit`.
void expect_same(const Answers& answers, const Answers& expected, double unit = 1.0) {
  ASSERT_EQ(answers.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bool none = std::isnan(answers[i]) && std::isnan(expected[i]);
    if (!none && test::bits(answers[i]) != test::bits(unit * expected[i])) ++different;
  }
  EXPECT_EQ(different, 0U) << "of " << answers.size();
}

TEST(StiffMetamorphic, UnitsOfAPowerOfTwoAreTheSameBitsOrRefused) {
  std::size_t answered = 0;
  for (const auto& [name, surface] : test::some_surfaces()) {
    const Questions asked = test::questions_for(surface);
    for (const Answerer& by : test::answerers()) {
      const Answers expected = by.answer(asked);
      for (const int exponent : {-200, -110, -90, -66, -40, 10, 66, 90, 110, 200}) {
        SCOPED_TRACE(std::string(name) + ", " + by.name + ", 2^" + std::to_string(exponent));
        Questions scaled = asked;
        scaled.unit = std::ldexp(1.0, exponent);
        for (Vec3& v : scaled.mesh.vertices) v *= scaled.unit;
        for (Vec3& x : scaled.points) x *= scaled.unit;
        try {
          expect_same(by.answer(scaled), expected, scaled.unit);
          ++answered;
        } catch (const std::exception& refused) {
          const std::string line = refused.what();
          EXPECT_GT(line.size(), 20U);
          EXPECT_EQ(line.find('\n'), std::string::npos) << line;
          EXPECT_GT(std::abs(exponent), 40) << line;
        }
      }
    }
  }
  EXPECT_EQ(answered, 16U);  // by both, of four surfaces, in units of 2^-40 and 2^10 mm
}

// Quarter turns and translations by multiples of 2^-8 mm move points of the same grid without rounding.
TEST(StiffMetamorphic, APoseWithoutRoundingIsThatOfTheMovedPoints) {
  for (const auto& [name, surface] : test::some_surfaces()) {
    Questions moved = test::questions_for(surface);
    for (Vec3& x : moved.points) x = (0x1p8 * x).array().round().matrix() * 0x1p-8;
    std::erase_if(moved.points, [](const Vec3& x) { return x.isZero(0.0); });
    const Answers tables = test::table_answers(moved);
    const Answers exact = test::exact_answers(moved);
    for (const double far : {0.0, 30000.0}) {
      SCOPED_TRACE(std::string(name) + ", " + std::to_string(far) + " mm");
      Questions asked = moved;
      asked.pose.translation = far * Vec3(1.0, -0.5, 0.75);
      asked.pose.rotation << 0, 0, -1, 1, 0, 0, 0, -1, 0;
      for (Vec3& x : asked.points) x = to_ball(asked.pose, x);
      expect_same(test::table_answers(asked), tables);
      expect_same(test::exact_answers(asked), exact);
    }
  }
}

TEST(StiffMetamorphic, TheOrderOfFacesAndVerticesChangesNothing) {
  std::mt19937_64 random(6);
  for (const auto& [name, surface] : test::some_surfaces()) {
    const Questions asked = test::questions_for(surface);
    std::vector<std::size_t> order(asked.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    Questions shuffled = asked;
    std::ranges::shuffle(shuffled.mesh.faces, random);
    for (std::size_t i = 0; i < order.size(); ++i) shuffled.points[i] = asked.points[order[i]];
    for (const Answerer& by : test::answerers()) {
      SCOPED_TRACE(std::string(name) + ", " + by.name);
      const Answers answers = by.answer(asked);
      Answers expected;
      for (std::size_t first = 0; first < answers.size(); first += order.size())
        for (const std::size_t i : order) expected.push_back(answers[first + i]);
      expect_same(by.answer(shuffled), expected);
    }
  }
}

TEST(StiffMetamorphic, ThreadsThatShareATableGetTheSameBits) {
  for (const auto& [name, surface] : test::some_surfaces()) {
    SCOPED_TRACE(name);
    const Questions asked = test::questions_for(surface);
    const auto kernels = test::table_kernels(asked.mesh, asked.layer, 15.0);
    std::vector<Answers> each(3 * kernels.size());
    {
      std::vector<std::jthread> threads;
      for (std::size_t t = 0; t < 3; ++t)
        threads.emplace_back([&, t] {
          for (std::size_t k = 0; k < kernels.size(); ++k)
            each[t * kernels.size() + k] = kernels[k]->gaps(asked.points, asked.pose, Surface::ball);
        });
    }
    for (std::size_t k = 0; k < each.size(); ++k)
      expect_same(each[k], kernels[k % kernels.size()]->gaps(asked.points, asked.pose, Surface::ball));
  }
}

}  // namespace
}  // namespace impinge::lab
