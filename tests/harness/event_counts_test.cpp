// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the numbers of a dump belong to its events by their order, first misses = D1mr + D1mw, second =
// DLmr + DLmw; count_run() runs three times and counts the third.
#include "harness/event_counts.hpp"

#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace impinge::lab {
namespace {

constexpr const char* kDump =
    "# callgrind format\nversion: 1\ncmd: x events: Ir\ndesc: Timerange: Basic block 0 - 2\n"
    "desc: Trigger: Client Request: cube;n=4;socket->ball\n\npositions: line\n"
    "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nsummary: 1000 200 30 4 50 6 7 8 1\n\nfn=(1) f\n3 1\n"
    "totals: 9 9 9 9 9 9 9 9 9\n";

TEST(EventCounts, AreThoseOfTheDump) {
  const EventCounts counts = parse_event_counts(kDump);
  EXPECT_EQ(counts.label, "cube;n=4;socket->ball");
  EXPECT_EQ(counts.instructions, 1000.0);
  EXPECT_EQ(counts.first_misses, 56.0);
  EXPECT_EQ(counts.second_misses, 9.0);
}

TEST(EventCounts, ThatAreNotInTheSummaryAreZero) {
  std::string dump = kDump;
  dump.replace(dump.find(" 7 8 1\n"), 6, "");
  const EventCounts counts = parse_event_counts(dump);
  EXPECT_EQ(counts.first_misses, 56.0);
  EXPECT_EQ(counts.second_misses, 0.0);
}

TEST(EventCounts, NeedALabelACacheAndASummary) {
  std::string dump = kDump;
  EXPECT_THROW(parse_event_counts(""), std::runtime_error);
  EXPECT_THROW(parse_event_counts(dump.substr(dump.find("positions"))), std::runtime_error);
  EXPECT_THROW(parse_event_counts(dump.substr(0, dump.find(" DLmw"))), std::runtime_error);
  dump.erase(dump.find("summary: "), std::string_view("summary: 1000 200 30 4 50 6 7 8 1\n").size());
  EXPECT_THROW(parse_event_counts(dump), std::runtime_error);
}

TEST(EventCounts, CountTheThirdRun) {
  int runs = 0;
  count_run("a", [&runs] { ++runs; });
  EXPECT_EQ(runs, 3);
}

TEST(EventCounts, SayWhatFailedAndLeaveNoFiles) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(count_events({"/bin/false"}, folder.path()), std::runtime_error);
  EXPECT_TRUE(count_events({"/bin/true"}, folder.path()).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace impinge::lab
