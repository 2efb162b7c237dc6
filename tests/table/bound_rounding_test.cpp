// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: rounding takes nothing from what a bound is made of, at the ends of ranges and where digits
// cancel. Held against long double:
//   tan psi within a cap <= range_within().slope, radii within [least, largest]
//   an edge that enters a cap meets() it
// And a bound above the radius of the surface is none. An entry is moved by rounding as far as
// direction_doubt() says, and bounds hold from there.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/bound_probes.hpp"
#include "support/dice.hpp"
#include "support/every_scheme.hpp"
#include "support/random_cases.hpp"
#include "support/wrapped_scheme.hpp"
#include "table/own_scheme.hpp"
#include "table/patch_error.hpp"
#include "table/surface_index.hpp"
#include "table/surface_kink.hpp"
#include "table/surface_plane.hpp"

namespace impinge {
namespace {

using Exact = Eigen::Matrix<long double, 3, 1>;
using test::Dice;

// A face round a direction u, square to it but for 1e-12 to 1e-2 radians, and a cap about as small beside u.
TEST(BoundRoundingAttack, APlaneSeenAtARightAngleHasItsSlope) {
  Dice dice(19);
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
  Dice dice(19);
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

// What the header derives: an azimuth of t turns has 8 roundings.
double rounding_of_turns(std::size_t turns) { return 8.0 * 0x1p-53 * 2.0 * kPi * static_cast<double>(turns); }

TEST(DirectionDoubt, IsNoLessThanTheRoundingOfAllTurns) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(2.0);
    EXPECT_GE(direction_doubt(scheme), rounding_of_turns(scheme.equator_points() + 1)) << S::name;
  });
}

// A curve of a million turns, whose stencils are one entry that is as near as this.
class ManyTurns : public test::Wrapped<Rsid> {
 public:
  static constexpr std::size_t kTurns = 1'000'000;
  static constexpr double kNear = 1e-9;  // radians
  static ManyTurns with_precision(double degrees) {
    ManyTurns scheme;
    scheme.hold(Rsid::with_precision(degrees));
    return scheme;
  }
  double stencil_radius() const { return kNear; }
  std::size_t equator_points() const { return kTurns; }
  Stencil stencil(const Vec3& x) const {
    const Stencil all = test::Wrapped<Rsid>::stencil(x);
    const std::size_t near = all.entry[static_cast<std::size_t>(
        std::max_element(all.weight.begin(), all.weight.end()) - all.weight.begin())];
    return {{near, near, near, near}, {1.0, 0.0, 0.0, 0.0}, 1, all.cell};
  }
};

// A slope of 45 degrees seen from an entry, along a direction that is farther than the stencil radius from it
// by what rounding may have moved the entry.
TEST(DirectionDoubt, ABoundHoldsForAnEntryThatRoundingHasMoved) {
  const auto scheme = ManyTurns::with_precision(10.0);
  const Vec3 u = scheme.direction(scheme.stencil(Vec3(1.0, 2.0, 3.0)).entry[0]);
  const Vec3 level = Vec3::UnitZ().cross(u).normalized();  // along the rows of the grid, as are the rims
  const Vec3 down = u.cross(level);
  const auto corner = [&](double a, double b) -> Vec3 { return 20.0 * u + a * (down - u) + b * level; };
  const TriangleMesh mesh{{corner(-0.2, -0.2), corner(0.3, -0.2), corner(0.3, 0.2), corner(-0.2, 0.2)},
                          {{0, 1, 2}, {0, 2, 3}}};
  const auto table = fill_exact(mesh, scheme, Layer::nearest);
  const double moved = ManyTurns::kNear + rounding_of_turns(ManyTurns::kTurns);
  const Exact x =
      u.cast<long double>() - std::tan(static_cast<long double>(moved)) * down.cast<long double>();
  const Exact normal = (u + down).cast<long double>();
  const auto truth =
      static_cast<double>(normal.dot(20.0L * u.cast<long double>()) / normal.dot(x) * x.norm());
  const double error = std::abs(table.radius_at(x.cast<double>()) - truth);
  EXPECT_GT(error, 0.99 * 20.0 * moved);
  EXPECT_LE(error, error_bound_at(table, largest_slopes(mesh, scheme), x.cast<double>()));
  EXPECT_LE(error, table_bound(mesh, table, Layer::nearest).bound_mm);
}

// The error of a patch that is one direction is that of a direction a little aside.
TEST(DirectionDoubt, APatchHasItsShareOfTheSlope) {
  constexpr double kDoubt = 1e-6;
  const TriangleMesh mesh{{{21, -1, -1}, {19, 1, -1}, {20, 0, 2}}, {{0, 1, 2}}};  // 45 degrees
  const SurfaceIndex surface(mesh, Layer::nearest, 0.01);
  PatchView view;
  view.motion.smooth = true;
  view.cap = {Vec3::UnitX(), 1e-9};
  view.point.fill(Vec3::UnitX());
  view.corner.fill({20.0, 20.0});
  view.least_tap = view.largest_tap = 20.0;
  EXPECT_GE(PatchError(surface, kDoubt)(view).bound, 20.0 * kDoubt);
}

}  // namespace
}  // namespace impinge
