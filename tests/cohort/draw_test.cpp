// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/draw.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "cohort/correlation.hpp"
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

}  // namespace
}  // namespace impinge::lab
