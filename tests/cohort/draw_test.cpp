// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "cohort/member.hpp"
#include "cohort/shard.hpp"
#include "cohort/spread.hpp"
#include "cohort/summary.hpp"
#include "hip/hip.hpp"
#include "support/thrown.hpp"

namespace impinge::lab {
namespace {

const HipParameter& parameter(std::string_view name) {
  for (const HipParameter& one : hip_parameter_list()) {
    if (one.name == name) return one;
  }
  throw std::invalid_argument(std::string(name));
}

Spread normal(std::string_view name, double mean, double sd) {
  const HipParameter& one = parameter(name);
  return {&one, Shape::normal, mean, sd, one.least, one.most, "test"};
}

Study study_of(std::vector<Spread> spreads, const std::vector<Correlation>& pairs) {
  Study study;
  study.seed = 5;
  study.hips = 10;
  study.spreads = std::move(spreads);
  study.mixing = mixing_of(study.spreads, pairs);
  return study;
}

// printf '5/version/3/0' | sha256sum, by another program; its first 13 digits as a share of 16^13.
TEST(Draw, IsTheHashOfWhatItIsFor) {
  EXPECT_EQ(uniform_draw(5, "version", 3, 0), 0.7300932614356795);
  EXPECT_EQ(uniform_draw(0, "cam_height", 123456789, 7), 0.9812515352637331);
}

TEST(Draw, IsUniformInThirtyTwoCells) {
  std::array<int, 32> count{};
  constexpr int kDraws = 32000;
  for (int j = 0; j < kDraws; ++j)
    ++count.at(static_cast<std::size_t>(32.0 * uniform_draw(1, "version", static_cast<std::size_t>(j), 0)));
  double chi_squared = 0.0;
  for (const int n : count) chi_squared += (n - 1000.0) * (n - 1000.0) / 1000.0;
  EXPECT_LT(chi_squared, 61.1);  // 31 degrees of freedom: one in a thousand seeds is above
  EXPECT_GT(chi_squared, 11.0);
}

TEST(Draw, HipFollowsFromStudyAndNumberAlone) {
  const Study one = study_of({normal("version", 18.0, 5.0)}, {});
  Study more = study_of({normal("femoral_torsion", 12.0, 8.0), normal("version", 18.0, 5.0)}, {});
  more.hips = 100000;
  for (const std::size_t j : {std::size_t{0}, std::size_t{9}, std::size_t{77777}}) {
    EXPECT_EQ(draw_hip(one, j).parameters.version, draw_hip(more, j).parameters.version);
    EXPECT_EQ(draw_hip(one, j).parameters.version, draw_hip(one, j).parameters.version);
  }
  more.seed = 6;
  EXPECT_NE(draw_hip(one, 4).parameters.version, draw_hip(more, 4).parameters.version);
}

TEST(Draw, HasMeanSpreadAndCorrelationOfTheStudy) {
  const Study study = study_of({normal("version", 18.0, 4.0), normal("femoral_torsion", 12.0, 9.0)},
                               {{"femoral_torsion", "version", 0.6}});
  double sums[5] = {};
  constexpr int kHips = 1500;
  for (int j = 0; j < kHips; ++j) {
    const HipParameters p = draw_hip(study, static_cast<std::size_t>(j)).parameters;
    const double a = (p.version - 18.0) / 4.0;
    const double b = (p.femoral_torsion - 12.0) / 9.0;
    const double terms[5] = {a, b, a * a, b * b, a * b};
    for (int k = 0; k < 5; ++k) sums[k] += terms[k] / kHips;
  }
  const double expected[5] = {0.0, 0.0, 1.0, 1.0, 0.6};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(sums[k], expected[k], 5.0 * std::sqrt(2.0 / kHips)) << k;
}

TEST(Draw, WhatMakesNoHipIsDrawnAgain) {
  Study study = study_of({normal("cam_height", 4.0, 3.0)}, {});
  study.start.cam_polar =
      100.0;  // under the roof of the socket: what is higher than the joint space penetrates it
  std::size_t redrawn = 0;
  for (std::size_t j = 0; j < 50; ++j) {
    const DrawnHip hip = draw_hip(study, j);
    redrawn += hip.redrawn;
    EXPECT_NO_THROW(make_hip(hip.parameters, kFewestHipFaces));
  }
  EXPECT_GT(redrawn, 10U);
  study.spreads[0].least = 12.0;
  const std::string why = test::thrown<std::runtime_error>([&] { draw_hip(study, 3); });
  EXPECT_EQ(why.substr(0, 47), "hip 3: 100 draws make no hip, the last one beca") << why;
}

TEST(Correlation, MixesToTheGivenMatrix) {
  const std::vector<Spread> spreads{normal("version", 0, 1), normal("inclination", 0, 1),
                                    normal("head_radius", 0, 1)};
  const std::vector<Correlation> pairs{{"version", "inclination", 0.9}, {"inclination", "head_radius", -0.4}};
  const Eigen::MatrixXd mixing = mixing_of(spreads, pairs);
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Identity(3, 3);
  wanted(0, 1) = wanted(1, 0) = 0.9;
  wanted(1, 2) = wanted(2, 1) = -0.4;
  EXPECT_LT((mixing * mixing.transpose() - wanted).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Correlation, RefusesWhatNoPopulationHas) {
  const std::vector<Spread> spreads{normal("version", 0, 1), normal("inclination", 0, 1),
                                    normal("head_radius", 0, 1)};
  const auto refused = [&](const std::vector<Correlation>& pairs) {
    return test::thrown<std::invalid_argument>([&] { mixing_of(spreads, pairs); });
  };
  const std::string none =
      "correlations: the matrix is not positive definite, no population has these; make some of them smaller";
  EXPECT_EQ(refused({{"version", "inclination", 0.7}, {"inclination", "head_radius", 0.7}}), "");  // 0.98 < 1
  EXPECT_EQ(refused({{"version", "inclination", 0.71}, {"inclination", "head_radius", 0.71}}), none);
  EXPECT_EQ(refused({{"version", "inclination", 0.9},
                     {"inclination", "head_radius", 0.9},
                     {"version", "head_radius", -0.9}}),
            none);
  EXPECT_EQ(refused({{"version", "inclination", 1.0}}), none);
  EXPECT_EQ(refused({{"version", "inclination", 0.1}, {"inclination", "version", 0.1}}),
            "correlations: inclination and version are one parameter or given twice; name each pair once");
  EXPECT_EQ(refused({{"version", "wall_thickness", 0.1}}),
            "correlations: 'wall_thickness' is no parameter with a distribution; give it one");
}

// Oracle: distribution functions written down with erfc(), against which the inverse must come out.

double share_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// Share of a normal distribution that is cut off at both ends.
double share_of_cut(double x, double from, double to) {
  if (from > 0.0) return 1.0 - share_of_cut(-x, -to, -from);  // digits of the upper tail
  return (share_below(x) - share_below(from)) / (share_below(to) - share_below(from));
}

constexpr double kScores[] = {-6.0, -2.5, -1.0, -0.1, 0.0, 0.3, 1.0, 2.5, 6.0};

Spread of_shape(Shape shape, double centre, double width, double least, double most) {
  return {nullptr, shape, centre, width, least, most, "test"};
}

TEST(Spread, NormalIsCutAtItsEndsAndKeepsItsShares) {
  const double ends[][2] = {{-3.0, 8.0}, {2.0, 3.0}, {9.0, 30.0}, {-40.0, -6.0}, {-200.0, 200.0}};
  for (const auto& [least, most] : ends) {
    const Spread spread = of_shape(Shape::normal, 1.0, 2.0, least, most);
    for (const double z : kScores) {
      const double x = value_at(spread, z);
      EXPECT_GE(x, least);
      EXPECT_LE(x, most);
      EXPECT_NEAR(share_of_cut((x - 1.0) / 2.0, (least - 1.0) / 2.0, (most - 1.0) / 2.0), share_below(z),
                  1e-9)
          << least << " " << most << " " << z;
    }
  }
}

TEST(Spread, WithoutEndsInReachItIsTheNormalDistribution) {
  const Spread spread = of_shape(Shape::normal, 10.0, 0.5, -1e3, 1e3);
  for (const double z : kScores) EXPECT_NEAR(value_at(spread, z), 10.0 + 0.5 * z, 1e-7);
}

TEST(Spread, CensoredPutsWhatIsBeyondOnTheEnd) {
  const Spread spread = of_shape(Shape::censored_normal, 1.0, 2.0, 0.0, 3.0);
  EXPECT_EQ(value_at(spread, -0.5), 0.0);
  EXPECT_EQ(value_at(spread, -4.0), 0.0);
  EXPECT_EQ(value_at(spread, 0.25), 1.5);
  EXPECT_EQ(value_at(spread, 1.5), 3.0);
}

TEST(Spread, LognormalHasItsMedianAndShares) {
  const Spread spread = of_shape(Shape::lognormal, 4.0, 0.5, 1.0, 30.0);
  for (const double z : kScores) {
    const double x = value_at(spread, z);
    EXPECT_NEAR(share_of_cut(std::log(x / 4.0) / 0.5, std::log(1.0 / 4.0) / 0.5, std::log(30.0 / 4.0) / 0.5),
                share_below(z), 1e-9);
  }
}

TEST(Spread, UniformHasItsShares) {
  const Spread spread = of_shape(Shape::uniform, 0.0, 1.0, 2.0, 6.0);
  for (const double z : kScores) EXPECT_NEAR((value_at(spread, z) - 2.0) / 4.0, share_below(z), 1e-12);
}

TEST(Spread, AnUnknownShapeNamesTheOthers) {
  EXPECT_EQ(test::thrown<std::invalid_argument>([] { shape_of("gaussian"); }),
            "no distribution is called 'gaussian'; there are normal, censored_normal, lognormal, uniform");
}

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
                                   {"turn_zone_mm2", "mm^2", ""},
                                   {"fine_turn_deg", "deg", ""}};

TEST(Summary, IntervalsOfMeshAndCentreAreQuantilesOfTheEndsWidenedByTheMesh) {
  const std::string rows =
      "0,limited,10,8,12,0.5,7,10.5\n"
      "1,limited,20,19,25,11.9,9,\n"
      "2,limited,90,80,95,,,\n";
  const auto found = summary_of(study_of_limits(), kColumns, rows);
  const auto& turn = found["quantities"]["turn_deg"];
  EXPECT_EQ(turn["n"], 3);
  EXPECT_DOUBLE_EQ(turn["mean"], 40.0);
  EXPECT_DOUBLE_EQ(turn["sd"], std::sqrt(0.5 * (30.0 * 30.0 + 20.0 * 20.0 + 50.0 * 50.0)));
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
  EXPECT_EQ(found["counts"]["turn_state"]["limited"], 3);
  EXPECT_EQ(found["counts"]["turn_clock"][0], 1);
  EXPECT_EQ(found["counts"]["turn_clock"][11], 1);
  EXPECT_FALSE(found["quantities"].contains("turn_low_deg"));
}

// A motion that meets nothing, or cannot begin, has an angle, too; it is no limit.
TEST(Summary, OnlyLimitsAreSummarised) {
  const std::string rows =
      "0,limited,10,8,,0.5,7,10.5\n"
      "1,free,180,170,,,900,170\n"
      "2,limited,30,19,35,11.9,9,\n"
      "3,blocked,0,0,,1.5,800,\n"
      "4,unknown,50,40,,,,\n"
      "5,,,,,,,\n";
  const auto found = summary_of(study_of_limits(), kColumns, rows);
  const auto& turn = found["quantities"]["turn_deg"];
  EXPECT_EQ(turn["n"], 2);
  EXPECT_DOUBLE_EQ(turn["mean"], 20.0);
  EXPECT_EQ(turn["without_limit"], nlohmann::json({{"free", 1}, {"blocked", 1}, {"unknown", 1}}));
  EXPECT_DOUBLE_EQ(turn["mesh"]["largest"], 0.5);
  for (const auto& entry : turn["quantiles"]) {
    if (entry["p"] != 0.5) continue;
    EXPECT_DOUBLE_EQ(entry["value"], 20.0);
    EXPECT_DOUBLE_EQ(entry["mesh_and_centre"][0], 13.0);
    EXPECT_EQ(entry["mesh_and_centre"][1].dump(), "null") << "one of both may have no limit";
  }
  EXPECT_DOUBLE_EQ(found["quantities"]["turn_zone_mm2"]["mean"], 8.0);
  EXPECT_EQ(found["counts"]["turn_state"]["free"], 1);
}

TEST(Summary, ACutRowIsSeen) {
  for (const char* rows :
       {"0,limited,10,8,12,0.5,1\n", "0,limited,10,8,12,0.5,1,1", "0,limited,10,8,12,0.5,1,1,2\n"}) {
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
