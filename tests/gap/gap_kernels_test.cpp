// SPDX-License-Identifier: GPL-3.0-or-later
// Contract:
//   |gap of the kernel - gap of the scalar look-up| <= u (20 (r + |x|) + (c m + 5) D) at points that are
//   floats, of a cube in 16 bits and 5 u Q r besides, and with a pose by what a displacement of 10.4 u (|v| +
//   |t|) does besides
//   one of them has no answer where the other has none, but within rounding of a grid line
#include "gap/simd/gap_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "mesh/generated_pair.hpp"
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

}  // namespace
}  // namespace impinge
