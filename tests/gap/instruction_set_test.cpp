// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: with every instruction set, for every number of vertices, the same bits; nothing beyond the
// vertices is written; what has no direction or is no number has no answer
#include "methods/instruction_set.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/simd/exact_cells.hpp"
#include "gap/simd/gap_kernels.hpp"
#include "mesh/generated_pair.hpp"
#include "table/packed_fixture.hpp"

namespace impinge {
namespace {

template <class Real>
using Pattern = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

// Bits of all gaps, every NaN as one: processors differ in the sign of theirs.
template <class Table>
std::vector<Pattern<typename Table::Real>> patterns(const Table& table, const std::vector<Vec3>& vertices) {
  using Real = typename Table::Real;
  const auto lanes = packed_vertices<Real>(vertices);
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.7, Vec3(0.36, 0.48, 0.8)).toRotationMatrix();
  pose.translation = Vec3(0.3, -0.2, 0.1);
  std::vector<Real> gap(vertices.size());
  std::vector<Pattern<Real>> bits;
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    scan_gaps(table, lanes, pose, scanned, gap);
    for (const Real value : gap) bits.push_back(std::isnan(value) ? 0U : std::bit_cast<Pattern<Real>>(value));
  }
  return bits;
}

template <class Table>
void expect_same_bits(const Table& table, const std::vector<Vec3>& vertices) {
  use_instruction_set(instruction_sets().back());
  const auto expected = patterns(table, vertices);
  for (const std::string& set : instruction_sets()) {
    use_instruction_set(set);
    EXPECT_EQ(patterns(table, vertices), expected) << set;
  }
  use_best_instruction_set();
}

TEST(InstructionSets, AllAnswerAlikeBitForBit) {
  const auto rsid = test::bumpy_table<Rsid>(1.5);
  const auto cube = test::bumpy_table<CubeGnomonic>(1.5);
  const auto points = test::float_points(rsid.scheme());
  expect_same_bits(packed_table<float>(cube), points);
  expect_same_bits(packed_table<std::uint16_t>(cube), points);
  expect_same_bits(packed_table<double>(rsid), points);
  expect_same_bits(packed_table<float>(rsid), points);
  expect_same_bits(packed_table<std::uint16_t>(rsid), points);
  const auto helix = test::bumpy_table<Usid>(1.5);
  expect_same_bits(packed_table<double>(helix), points);
  expect_same_bits(packed_table<float>(helix), points);
  expect_same_bits(packed_table<std::uint16_t>(helix), points);
  const BallSocketPair pair = make_ball_socket_pair(1000);
  expect_same_bits(exact_cells(pair.ball, Layer::farthest), points);
  expect_same_bits(exact_cells(pair.socket, Layer::nearest), points);
}

TEST(InstructionSets, AnyNumberOfVertices) {
  const auto table = packed_table<float>(test::bumpy_table<CubeGnomonic>(3.0));
  const auto points = test::random_directions(40, 3);
  const auto lanes = packed_vertices<float>(points);
  std::vector<float> all(points.size());
  scan_gaps(table, lanes, {}, Surface::ball, all);
  for (const std::string& set : instruction_sets()) {
    use_instruction_set(set);
    for (std::size_t count = 0; count <= points.size(); ++count) {
      const auto some = packed_vertices<float>(std::span(points).first(count));
      std::vector<float> gap(count + 1, 7.0F);
      scan_gaps(table, some, {}, Surface::ball, std::span(gap).first(count));
      for (std::size_t i = 0; i < count; ++i)
        EXPECT_TRUE(gap[i] == all[i] || (std::isnan(gap[i]) && std::isnan(all[i])));
      EXPECT_EQ(gap.back(), 7.0F) << set << " wrote beyond " << count;
    }
  }
  use_best_instruction_set();
}

TEST(InstructionSets, WhatHasNoDirectionHasNoAnswer) {
  const double huge = std::numeric_limits<float>::max();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<Vec3> odd{{0, 0, 0},          {infinite, 0, 0},
                              {0, kNoSurface, 1}, {-infinite, infinite, 1},
                              {1, 1, -infinite},  {kNoSurface, kNoSurface, kNoSurface},
                              {huge, huge, huge}, {-0.0, 0, -0.0}};
  const auto table = packed_table<std::uint16_t>(test::bumpy_table<CubeGnomonic>(3.0));
  const auto grid = packed_table<double>(test::bumpy_table<Rsid>(3.0));
  const auto helix = packed_table<std::uint16_t>(test::bumpy_table<Usid>(3.0));
  for (const std::string& set : instruction_sets()) {
    use_instruction_set(set);
    std::vector<float> gap(odd.size());
    scan_gaps(table, packed_vertices<float>(odd), {}, Surface::ball, gap);
    std::vector<double> wide(odd.size());
    scan_gaps(grid, packed_vertices<double>(odd), {}, Surface::ball, wide);
    std::vector<double> wound(odd.size());
    scan_gaps(helix, packed_vertices<double>(odd), {}, Surface::ball, wound);
    for (const std::size_t i : {0U, 2U, 5U, 7U}) {
      EXPECT_TRUE(std::isnan(gap[i])) << set << " " << i;
      EXPECT_TRUE(std::isnan(wide[i])) << set << " " << i;
      EXPECT_TRUE(std::isnan(wound[i])) << set << " " << i;
    }
    for (const float value : gap) EXPECT_FALSE(std::isfinite(value)) << set;
  }
  use_best_instruction_set();
}

TEST(InstructionSets, UnknownNamesAreRefused) {
  EXPECT_THROW(use_instruction_set("MMX"), std::invalid_argument);
  EXPECT_FALSE(instruction_sets().empty());
}

}  // namespace
}  // namespace impinge
