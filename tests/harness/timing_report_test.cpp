// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/timing_report.hpp"

#include <string>

#include <gtest/gtest.h>

namespace impinge::lab {
namespace {

// Two cases with known samples; the control differs from the first by 1 %.
TimingRun known_run() {
  TimingRun run;
  for (const auto& [name, samples] : {std::pair<const char*, std::vector<double>>{"rsid", {2.0, 2.0, 2.0}},
                                      {"pairwise", {10.0, 20.0, 30.0}}}) {
    Timing timing;
    timing.key = {name, 3000};
    timing.samples_ms = samples;
    timing.summary = summarise(samples);
    timing.batch = 8;
    timing.inconclusive = name == std::string("pairwise");
    timing.repeats = timing.inconclusive ? 3 : 0;
    run.timings.push_back(timing);
  }
  run.control = run.timings[0];
  run.control_ratio = 1.01;
  return run;
}

TEST(TimingReport, KeepsEverySample) {
  const Table table = samples_table({{"method", "", ""}, {"triangles", "1", ""}}, known_run());
  EXPECT_EQ(to_csv(table),
            "method,triangles,round,ms\nrsid,3000,1,2\nrsid,3000,2,2\nrsid,3000,3,2\n"
            "pairwise,3000,1,10\npairwise,3000,2,20\npairwise,3000,3,30\n");
}

TEST(TimingReport, RowsHaveTheColumnsOfTheContract) {
  Table table{timing_columns({{"method", "", ""}, {"triangles", "1", ""}}), {}};
  table.add_row(timing_cells(known_run().timings[1]));
  table.add_row(extrapolated_cells({"pairwise", 12000}, scaled(known_run().timings[1], 16.0)));
  EXPECT_EQ(to_csv(table),
            "method,triangles,median_ms,iqr_ms,rounds,extrapolated,inconclusive,repeats\n"
            "pairwise,3000,20,10,3,no,yes,3\npairwise,12000,320,160,3,yes,yes,3\n");
}

// A unit of work once more in nanoseconds: a million a millisecond.
TEST(TimingReport, MediansAreInNanosecondsToo) {
  const Table table = medians_in_ns({{"method", "", ""}, {"triangles", "1", ""}}, known_run(), "look-up");
  EXPECT_EQ(to_csv(table),
            "method,triangles,median_ms,iqr_ms,rounds,extrapolated,inconclusive,repeats,median_ns\n"
            "rsid,3000,2,0,3,no,no,0,2e+06\npairwise,3000,20,10,3,no,yes,3,2e+07\n");
  EXPECT_EQ(table.columns.back().meaning, "the median for one look-up");
}

TEST(TimingReport, RecordsControlAndInconclusiveCases) {
  const nlohmann::json record = timing_record(known_run());
  EXPECT_EQ(record["control"]["case"], "rsid/3000");
  EXPECT_DOUBLE_EQ(record["control"]["ratio"].get<double>(), 1.01);
  EXPECT_EQ(record["control"]["samples_ms"].size(), 3U);
  EXPECT_EQ(record["inconclusive"], nlohmann::json::array({"pairwise/3000"}));
  EXPECT_EQ(record["repeats"], (nlohmann::json{{"pairwise/3000", 3}}));
  EXPECT_EQ(record["batch"]["rsid/3000"], 8);
}

}  // namespace
}  // namespace impinge::lab
