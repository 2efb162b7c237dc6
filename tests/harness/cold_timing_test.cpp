// SPDX-License-Identifier: GPL-3.0-or-later
// What is counted: each case runs once untimed and once a round, in an order that changes; a sample is a
// unit.
#include "harness/cold_timing.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

TEST(ColdTiming, RunsEachCaseOnceARoundInOrdersOfTheirOwn) {
  std::vector<std::string> calls;
  std::vector<ColdCase> cases;
  for (const std::string name : {"a", "b", "c"})
    cases.push_back({{name}, [&calls, name] { calls.push_back(name); }});
  const std::vector<Timing> timings = time_cold(cases, {12, 1 << 10, 5});
  ASSERT_EQ(timings.size(), 3U);
  EXPECT_EQ(calls.size(), 3U * 13U);
  std::set<std::string> orders;
  for (std::size_t k = 3; k < calls.size(); k += 3) orders.insert(calls[k] + calls[k + 1] + calls[k + 2]);
  EXPECT_GT(orders.size(), 2U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(timings[i].key.front().text(), cases[i].key.front().text());
    EXPECT_EQ(timings[i].samples_ms.size(), 12U);
    EXPECT_EQ(timings[i].summary.count, 12U);
  }
}

// One run of a thousand units is a thousand times as long as a unit of it.
TEST(ColdTiming, SamplesAreThoseOfAUnit) {
  const auto work = [] {
    volatile double sum = 0.0;
    for (int k = 0; k < 100000; ++k) sum = sum + k;
  };
  const std::vector<Timing> timings = time_cold({{{"whole"}, work, 1.0}, {{"unit"}, work, 1e6}}, {5, 64, 1});
  EXPECT_GT(timings[0].summary.median, 100.0 * timings[1].summary.median);
}

}  // namespace
}  // namespace impinge::lab
