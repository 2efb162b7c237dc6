// SPDX-License-Identifier: GPL-3.0-or-later
// Contract:
//   |gap of the kernel - gap of the scalar look-up| <= u (20 (r + |x|) + (c m + 5) D) at points that are
//   floats, of a cube in 16 bits and 5 u Q r besides, and with a pose by what a displacement of 10.4 u (|v| +
//   |t|) does besides
//   one of them has no answer where the other has none, but within rounding of a grid line
#include "gap/simd/gap_kernels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "gap/simd/exact_cells.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/instruction_set.hpp"
#include "sphere/stored_table.hpp"
#include "sphere/uniform_directions.hpp"
#include "table/exact_raster.hpp"
#include "table/packed_fixture.hpp"

namespace impinge {
namespace {

// The scheme, what its tables hold, and the scalar table that holds the same numbers.
template <class SchemeT, class ValueT, class ScalarT>
struct Kind {
  using S = SchemeT;
  using Value = ValueT;
  using Scalar = ScalarT;
  using Lanes = PackedTable<S, Value>;
  using Real = typename Lanes::Real;
  static constexpr bool kCube = std::same_as<S, CubeGnomonic>;
  static constexpr double kUnit = sizeof(Real) == 4 ? 0x1p-24 : 0x1p-53;
  static constexpr bool kHelix = std::same_as<S, Usid>;

  // c, m being the cells of a quarter turn
  static double place(const S& scheme) {
    const double m = 0.25 * static_cast<double>(scheme.equator_points());
    return kCube ? 13.0 : kHelix ? 10.0 + 52.0 * m : 28.0;
  }

  // Of a length of a gap and a radius, mm; 3 is more than the range of the numbers of most bodies here
  static double rounded(double both, double radius, double range = 3.0) {
    return 20.0 * both + (kCube && sizeof(Value) == 2 ? 5.0 * range * radius : 0.0);
  }

  // The whole of it, without a pose
  static double rounding(const RadialTable<S>& table, const Vec3& x, double radius, double range = 3.0) {
    const double m = 0.25 * static_cast<double>(table.scheme().equator_points());
    return kUnit * (rounded(radius + x.norm(), radius, range) +
                    (place(table.scheme()) + 5.0 / m) * test::steps_at(table, x, 16.0 * kUnit, radius));
  }
};
using Kinds =
    testing::Types<Kind<CubeGnomonic, float, FloatInverseDepthTable<CubeGnomonic>>,
                   Kind<CubeGnomonic, std::uint16_t, Uint16InverseDepthTable<CubeGnomonic>>,
                   Kind<Rsid, float, FloatTable<Rsid>>, Kind<Rsid, std::uint16_t, Uint16Table<Rsid>>,
                   Kind<Rsid, double, RadialTable<Rsid>>, Kind<Usid, float, FloatTable<Usid>>,
                   Kind<Usid, std::uint16_t, Uint16Table<Usid>>, Kind<Usid, double, RadialTable<Usid>>>;

template <class K>
std::vector<typename K::Real> kernel_gaps(const typename K::Lanes& table, const std::vector<Vec3>& vertices,
                                          const Pose& pose, Surface scanned) {
  const auto lanes = packed_vertices<typename K::Real>(vertices);
  std::vector<typename K::Real> gap(vertices.size());
  scan_gaps(table, lanes, pose, scanned, gap);
  return gap;
}

// m D: cells of a quarter turn, times the largest step of radius between neighbours.
template <class K>
double steps(const typename K::S& scheme, const RadialTable<typename K::S>& table) {
  const double quarter = 0.25 * static_cast<double>(scheme.equator_points());
  double largest = 0.0;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const Stencil stencil = scheme.stencil(scheme.direction(i));
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      const double step = std::abs(table.radii()[stencil.entry[k]] - table.radii()[i]);
      if (!std::isnan(step)) largest = std::max(largest, step);
    }
  }
  return quarter * largest;
}

// Within rounding of x, is there an answer (or none) as the kernel says?
template <class K, class Table>
bool said_close_by(const Table& table, const Vec3& x, bool none) {
  return std::ranges::any_of(test::close_to(x, 64.0 * K::kUnit),
                             [&](const Vec3& near) { return std::isnan(table.radius_at(near)) == none; });
}

template <class K>
class GapKernels : public testing::Test {};
TYPED_TEST_SUITE(GapKernels, Kinds);

TYPED_TEST(GapKernels, AnswerAsTheScalarTable) {
  using K = TypeParam;
  for (const double precision : {10.0, 1.5}) {
    const auto radii = test::bumpy_table<typename K::S>(precision);
    const typename K::Scalar scalar(radii);
    const auto table = packed_table<typename K::Value>(radii);
    const auto points = test::float_points(radii.scheme());
    const auto gap = kernel_gaps<K>(table, points, {}, Surface::ball);
    std::size_t none = 0;
    std::size_t otherwise = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double radius = scalar.radius_at(points[i]);
      const double length = points[i].norm();
      none += std::isnan(gap[i]) ? 1U : 0U;
      if (std::isnan(gap[i]) != std::isnan(radius)) {
        ++otherwise;
        EXPECT_TRUE((said_close_by<K>(scalar, points[i], std::isnan(gap[i])))) << points[i].transpose();
      }
      if (std::isnan(gap[i]) || std::isnan(radius)) continue;
      ASSERT_NEAR(gap[i], radius - length, K::rounding(radii, points[i], radius)) << points[i].transpose();
    }
    EXPECT_GT(none, 100U);
    EXPECT_LT(otherwise, points.size() / 100);
  }
}

// Radii from 1 to 1,000 mm beside each other: a cell changes an inverse depth by much more of itself than it
// does a radius.
TYPED_TEST(GapKernels, AnswerAsTheScalarTableInSteepCells) {
  using K = TypeParam;
  std::mt19937_64 random(6);
  for (const double precision : {30.0, 5.0, 1.0}) {
    RadialTable<typename K::S> radii(K::S::with_precision(precision));
    for (double& r : radii.radii()) r = std::pow(10.0, 3.0 * uniform(random));
    if constexpr (!K::kHelix) {  // entries of one direction
      for (std::size_t i = 0; i < radii.scheme().size(); ++i) {
        const Stencil stencil = radii.scheme().stencil(radii.scheme().direction(i));
        const auto same = std::max_element(stencil.weight.begin(), stencil.weight.end());
        radii.radii()[i] =
            radii.radii()[stencil.entry[static_cast<std::size_t>(same - stencil.weight.begin())]];
      }
    }
    const typename K::Scalar scalar(radii);
    const auto table = packed_table<typename K::Value>(radii);
    const auto points = test::float_points(radii.scheme());
    const auto gap = kernel_gaps<K>(table, points, {}, Surface::ball);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double radius = scalar.radius_at(points[i]);
      ASSERT_NEAR(gap[i], radius - points[i].norm(), K::rounding(radii, points[i], radius, 1800.0))
          << points[i].transpose();
    }
  }
}

// One scan against a surface with a rim, the other against a closed one, as the library answers in double.
TYPED_TEST(GapKernels, BothScansOfARealPairInAnyPose) {
  using K = TypeParam;
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const auto scheme = K::S::with_precision(3.0);
  std::mt19937_64 random(5);
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    const bool first = scanned == Surface::ball;
    const auto radii = first ? fill_exact(pair.socket, scheme, Layer::nearest)
                             : fill_exact(pair.ball, scheme, Layer::farthest);
    const typename K::Scalar scalar(radii);
    const auto table = packed_table<typename K::Value>(radii);
    const double slope = steps<K>(scheme, radii);  // mm a radian, no less
    for (int k = 0; k < 10; ++k) {
      Pose pose;
      pose.rotation = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
      pose.translation = 2.0 * (uniform(random) - 0.5) * uniform_direction(random);
      const auto& vertices = first ? pair.ball.vertices : pair.socket.vertices;
      const auto gap = kernel_gaps<K>(table, vertices, pose, scanned);
      std::size_t otherwise = 0;
      for (std::size_t i = 0; i < gap.size(); ++i) {
        const Vec3 x = first ? to_socket(pose, vertices[i]) : to_ball(pose, vertices[i]);
        const double radius = scalar.radius_at(x);
        const double expected = first ? radius - x.norm() : x.norm() - radius;
        if (std::isnan(gap[i]) != std::isnan(radius)) ++otherwise;
        if (std::isnan(gap[i]) || std::isnan(radius)) continue;
        const double moved = 10.4 * (vertices[i].norm() + pose.translation.norm());
        const double bound = K::kUnit * (K::rounded(radius + x.norm(), radius) + K::place(scheme) * slope +
                                         moved * (1.0 + 2.0 * slope / x.norm()));
        ASSERT_NEAR(gap[i], expected, bound);
      }
      EXPECT_LE(otherwise, gap.size() / 100);
    }
  }
}

TYPED_TEST(GapKernels, TakesTheBytesOfItsEntriesAndMask) {
  using K = TypeParam;
  const auto radii = test::bumpy_table<typename K::S>(3.0);
  const auto table = packed_table<typename K::Value>(radii);
  const std::size_t more = K::kCube ? 0 : K::kHelix ? 4 : radii.scheme().size() / 120;
  const std::size_t entries = radii.scheme().size() + more;
  const std::size_t cells = K::kHelix ? radii.scheme().cells() : entries;
  const std::size_t words = cells / (8 * sizeof(typename K::Lanes::Word)) + 1;
  EXPECT_EQ(table.bytes(), entries * sizeof(typename K::Value) + words * sizeof(typename K::Lanes::Word));
}

// Contract: with every instruction set, for every number of vertices, the same bits; nothing beyond the
// vertices is written; what has no direction or is no number has no answer

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
