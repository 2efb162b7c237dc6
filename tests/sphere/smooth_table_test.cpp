// SPDX-License-Identifier: GPL-3.0-or-later
// A table of a function is as good as the function.
#include "sphere/smooth_table.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace impinge {
namespace {

void expect_as_good(const std::function<double(double)>& f, double end) {
  const SmoothTable table(f, end);
  for (double x = end; x > 1e-15 * end; x *= 0.97) EXPECT_NEAR(table(x), f(x), 2e-15 * f(x)) << x;
}

TEST(SmoothTable, MeetsEntireFunctions) {
  expect_as_good([](double) { return 3.0; }, 2.0);
  expect_as_good([](double x) { return 1.0 + x * x; }, 1e-3);
  expect_as_good([](double x) { return std::exp(x); }, 5.0);
}

// With a singularity at -end / 10^9, over nine orders of magnitude.
TEST(SmoothTable, FollowsAFunctionThatChangesFastNearZero) {
  for (const double end : {1e-6, 1.0, 1e6}) {
    expect_as_good([end](double x) { return std::sqrt(x / end + 1e-9); }, end);
    expect_as_good([end](double x) { return 1.0 / (x / end + 1e-9); }, end);
    expect_as_good([end](double x) { return std::hypot(x / end, 1e-9); }, end);
  }
}

}  // namespace
}  // namespace impinge
