// SPDX-License-Identifier: GPL-3.0-or-later
// A lap takes no less than what was done in it, and begins where the last one ended.
#include "files/stopwatch.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace impinge {
namespace {

TEST(Stopwatch, LapsAreWhatTheyLast) {
  using std::chrono::milliseconds;
  const auto before = std::chrono::steady_clock::now();
  Stopwatch watch;
  std::this_thread::sleep_for(milliseconds(4));
  const double first_ms = watch.lap_ms();
  std::this_thread::sleep_for(milliseconds(2));
  const double second_s = watch.lap_s();
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - before;
  EXPECT_GE(first_ms, 4.0);
  EXPECT_GE(second_s, 0.002);
  EXPECT_LE(1e-3 * first_ms + second_s, whole.count() + 1e-9);
}

}  // namespace
}  // namespace impinge
