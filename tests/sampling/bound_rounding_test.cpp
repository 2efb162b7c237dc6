// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: rounding takes nothing from what a bound is made of, at the ends of ranges and where digits
// cancel. Held against long double:
//   tan psi within a cap <= range_within().slope, radii within [least, largest]
//   an edge that enters a cap meets() it, and a face that does has a range in it
// And a bound above the radius of the surface is none.
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "sampling/cap_range.hpp"
#include "sampling/exact_raster.hpp"
#include "sampling/surface_kink.hpp"
#include "sampling/surface_plane.hpp"
#include "sampling/table_bound.hpp"
#include "support/bound_probes.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using Exact = Eigen::Matrix<long double, 3, 1>;

class Dice {
 public:
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3(normal(engine_), normal(engine_), normal(engine_)).normalized();
  }
  double power(double from, double to) {
    return std::pow(10.0, std::uniform_real_distribution<double>(from, to)(engine_));
  }

 private:
  std::mt19937_64 engine_{19};
};

// A face round a direction u, square to it but for 1e-12 to 1e-2 radians, and a cap about as small beside u.
TEST(BoundRoundingAttack, APlaneSeenAtARightAngleHasItsSlope) {
  Dice dice;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 u = dice.direction();
    const Vec3 east = u.unitOrthogonal();
    const Vec3 north = u.cross(east);
    const double tilt = dice.power(-12.0, -2.0);
    const auto on_plane = [&](double a, double b) -> Vec3 {
      return 20.0 * u + a * (east + tilt * u) + b * north;
    };
    const TriangleCone cone(on_plane(-9, -8), on_plane(9, -7), on_plane(1, 9));
    const SurfacePlane plane = surface_plane(cone);
    const DirectionCap cap{(u + dice.power(-12.0, -2.0) * east).normalized(), dice.power(-12.0, -2.0)};
    const PlaneRange range = range_within(plane, cap);
    const auto& v = cone.corners();
    const Exact a = v[0].cast<long double>();
    const Exact normal = (v[1].cast<long double>() - a).cross(v[2].cast<long double>() - a);
    const Exact axis = cap.axis.cast<long double>().normalized();
    const long double reach = static_cast<long double>(cap.radius) * (1.0L - 1e-15L);
    for (int side = 0; side < 4; ++side) {
      const Exact way = ((side < 2 ? 1.0 : -1.0) * (side % 2 == 0 ? east : north)).cast<long double>();
      const Exact across = (way - way.dot(axis) * axis).normalized();
      const Exact x = std::cos(reach) * axis + std::sin(reach) * across;
      const long double along = normal.dot(x);
      const auto slope = normal.cross(x).norm() / std::abs(along);
      const auto radius = normal.dot(a) / along * x.norm();
      ASSERT_LE(slope, static_cast<long double>(range.slope)) << tilt << ' ' << cap.radius;
      ASSERT_GE(radius, static_cast<long double>(range.least)) << tilt << ' ' << cap.radius;
      ASSERT_LE(radius, static_cast<long double>(range.largest)) << tilt << ' ' << cap.radius;
    }
  }
}

// Edges from 1e-9 to 1 radian, and a cap that the middle of the edge is only just in; sideways, where the
// normal of the edge decides.
TEST(BoundRoundingAttack, AShortEdgeMeetsACapThatItEnters) {
  Dice dice;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 from = 20.0 * dice.direction();
    const Vec3 to = from + 20.0 * dice.power(-9.0, -0.3) * dice.direction();
    const auto kink = surface_kink(from, to, Vec3::UnitX());
    if (!kink) continue;
    const Exact a = from.cast<long double>();
    const Exact along = to.cast<long double>() - a;
    const Exact normal = a.cross(along).normalized();
    const Exact middle = (a + 0.5L * along).normalized();
    const long double aside = static_cast<long double>(dice.power(-11.0, -3.0));
    const Exact exact = std::cos(aside) * middle + std::sin(aside) * normal;
    const Vec3 axis = exact.cast<double>();
    const long double distance =
        std::atan2(axis.cast<long double>().cross(middle).norm(), axis.cast<long double>().dot(middle));
    ASSERT_TRUE(meets(*kink, {axis, static_cast<double>(distance * (1.0L + 1e-15L))}))
        << (to - from).norm() << ' ' << static_cast<double>(aside);
  }
}

// A corner of a face in the very middle of a cap, both as small as they come.
TEST(BoundRoundingAttack, AFaceInASmallCapHasARange) {
  Dice dice;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 a = 20.0 * dice.direction();
    const double size = dice.power(-8.0, -2.0);
    const TriangleCone cone(a, a + size * dice.direction(), a + size * dice.direction());
    if (cone.edge_on()) continue;
    const double reach = dice.power(-10.0, -3.0);
    const Vec3 u = a.normalized();
    const DirectionCap cap{(u + 0.99 * reach * u.unitOrthogonal()).normalized(), reach};
    const auto part = FaceRange(cone).in_cap(cap);
    ASSERT_TRUE(part.has_value()) << size << ' ' << reach;
    ASSERT_LE(part->range.low, a.norm());
    ASSERT_GE(part->range.high, a.norm());
  }
}

TEST(BoundRounding, ABoundAboveTheSurfaceIsNone) {
  using Far = test::FarTap<CubeGnomonic>;
  const TriangleMesh mesh = cone();
  for (const double precision : {1.0, 45.0}) {
    const auto table = fill_exact(mesh, Far::with_precision(precision), Layer::farthest);
    const TableBound bound = table_bound(mesh, table, Layer::farthest);
    EXPECT_EQ(std::isinf(bound.bound_mm), precision > 1.0) << bound.bound_mm;
    EXPECT_EQ(std::isinf(bound.a_priori_mm), precision > 1.0);
  }
}

}  // namespace
}  // namespace impinge
