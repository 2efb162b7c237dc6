// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/progress.hpp"

#include <sstream>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

TEST(Progress, DurationsReadWell) {
  EXPECT_EQ(duration_text(-1.0), "0 s");
  EXPECT_EQ(duration_text(0.2), "1 s");
  EXPECT_EQ(duration_text(59.0), "59 s");
  EXPECT_EQ(duration_text(65.0), "1 min 05 s");
  EXPECT_EQ(duration_text(3600.0), "60 min 00 s");
}

TEST(Progress, EachMessageIsALineThatBeginsWithTheName) {
  std::ostringstream out;
  Progress progress("02_sampling_time", &out);
  progress.say("verifying");
  EXPECT_EQ(out.str(), "02_sampling_time: verifying\n");
}

TEST(Progress, TimeLeftIsTheExpectationUntilWorkIsDoneAndZeroAtTheEnd) {
  Progress progress("test", nullptr);
  progress.begin(100.0);
  EXPECT_DOUBLE_EQ(progress.seconds_left(), 100.0);
  progress.advance(60.0, "a");
  progress.advance(60.0, "b");  // more than expected
  EXPECT_DOUBLE_EQ(progress.seconds_left(), 0.0);
}

}  // namespace
}  // namespace impinge::lab
