// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/summary.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cohort/shard.hpp"
#include "support/thrown.hpp"

namespace impinge::lab {
namespace {

// P(fewer than k of n draws are below the quantile p), term by term.
double fewer(std::size_t k, std::size_t n, double p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < k; ++i) {
    const auto x = static_cast<double>(i);
    const auto m = static_cast<double>(n);
    sum += std::exp(std::lgamma(m + 1.0) - std::lgamma(x + 1.0) - std::lgamma(m - x + 1.0) + x * std::log(p) +
                    (m - x) * std::log1p(-p));
  }
  return sum;
}

TEST(RankInterval, HoldsTheQuantileWithNineteenInTwentyAndIsNoWiderThanItMust) {
  for (const std::size_t n : {1U, 2U, 20U, 59U, 60U, 200U, 1000U}) {
    for (const double p : {0.01, 0.05, 0.25, 0.5, 0.9, 0.975}) {
      const RankInterval found = rank_interval(n, p);
      if (found.low > 0) {
        EXPECT_LE(fewer(found.low, n, p), 0.025 + 1e-12);
      }
      if (found.low < n) {
        EXPECT_GT(fewer(found.low + 1, n, p), 0.025 - 1e-12) << n << " " << p;
      }
      if (found.high <= n) {
        EXPECT_LE(1.0 - fewer(found.high, n, p), 0.025 + 1e-12);
      }
      if (found.high > 1) {
        EXPECT_GT(1.0 - fewer(found.high - 1, n, p), 0.025 - 1e-12) << n << " " << p;
      }
    }
  }
}

Study study_of_limits() {
  Study study;
  study.text = {{"title", "test"}};
  return study;
}

const std::vector<Column> kColumns{{"hip", "1", ""},
                                   {"turn_state", "", ""},
                                   {"turn_deg", "deg", ""},
                                   {"turn_low_deg", "deg", ""},
                                   {"turn_high_deg", "deg", ""},
                                   {"turn_clock", "h", ""},
                                   {"fine_turn_deg", "deg", ""}};

TEST(Summary, IntervalsOfMeshAndCentreAreQuantilesOfTheEndsWidenedByTheMesh) {
  const std::string rows =
      "0,limited,10,8,12,0.5,10.5\n"
      "1,limited,20,19,25,11.9,\n"
      "2,free,180,170,180,,\n";
  const auto found = summary_of(study_of_limits(), kColumns, rows);
  const auto& turn = found["quantities"]["turn_deg"];
  EXPECT_EQ(turn["n"], 3);
  EXPECT_DOUBLE_EQ(turn["mean"], 70.0);
  EXPECT_DOUBLE_EQ(turn["sd"], std::sqrt(0.5 * (60.0 * 60.0 + 50.0 * 50.0 + 110.0 * 110.0)));
  EXPECT_EQ(turn["mesh"]["checked"], 1);
  EXPECT_DOUBLE_EQ(turn["mesh"]["largest"], 0.5);
  for (const auto& entry : turn["quantiles"]) {
    if (entry["p"] == 0.5) {
      EXPECT_DOUBLE_EQ(entry["value"], 20.0);
      EXPECT_DOUBLE_EQ(entry["mesh_and_centre"][0], 18.5);
      EXPECT_DOUBLE_EQ(entry["mesh_and_centre"][1], 25.5);
      EXPECT_TRUE(entry["sampling"][0].is_null()) << "three draws bound no median with 95 %";
    }
  }
  EXPECT_EQ(found["counts"]["turn_state"]["limited"], 2);
  EXPECT_EQ(found["counts"]["turn_state"]["free"], 1);
  EXPECT_EQ(found["counts"]["turn_clock"][0], 1);
  EXPECT_EQ(found["counts"]["turn_clock"][11], 1);
  EXPECT_FALSE(found["quantities"].contains("turn_low_deg"));
}

TEST(Summary, ACutRowIsSeen) {
  for (const char* rows :
       {"0,limited,10,8,12,0.5\n", "0,limited,10,8,12,0.5,1", "0,limited,10,8,12,0.5,1,2\n"}) {
    EXPECT_EQ(test::thrown<std::runtime_error>([&] { summary_of(study_of_limits(), kColumns, rows); }),
              "a row of the cohort is cut");
  }
}

TEST(Shard, PartsAreEvenAndLeaveNoHipOut) {
  for (const std::size_t hips : {0U, 1U, 10U, 199U, 200U}) {
    for (const std::size_t of : {1U, 7U, 12U, 1000U}) {
      std::size_t next = 0;
      for (std::size_t i = 1; i <= of; ++i) {
        const ShardHips part = hips_of({i, of}, hips);
        EXPECT_EQ(part.first, next);
        EXPECT_LE(part.last - part.first, hips / of + 1);
        EXPECT_GE(part.last - part.first, hips / of);
        next = part.last;
      }
      EXPECT_EQ(next, hips);
    }
  }
}

TEST(Shard, IsReadOrRefused) {
  EXPECT_EQ(parse_shard("3/12").i, 3U);
  EXPECT_EQ(parse_shard("12/12").of, 12U);
  for (const char* text : {"0/0", "0/3", "4/3", "1", "1/", "/2", "-1/2", "1/2/3", "1.5/2", "1 /2", "",
                           "99999999999999999999/2"}) {
    EXPECT_EQ(test::thrown<std::invalid_argument>([&] { parse_shard(text); }),
              "'" + std::string(text) + "' is no shard; give i/K with i from 1 to K, as 3/12");
  }
}

}  // namespace
}  // namespace impinge::lab
