// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 7:  sqrt(2) pi r / n        Eq. 8:  sqrt(2) pi / n
// One plane:  |error| <= rho^2 / 2 * max r (1 + 2 tan^2 psi)   for taps within a circle of radius rho
#include "04_sampling_error/sampling_error.hpp"

#include <array>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "sphere/radial_table.hpp"
#include "support/every_scheme.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

TEST(ThesisFormula, GivesTheThesisTable) {
  constexpr std::array<std::array<double, 3>, 4> table{
      {{360, 0.272, 1.23}, {720, 0.136, 0.62}, {3600, 0.027, 0.12}, {7200, 0.014, 0.06}}};
  for (const auto& [points, error, percent] : table) {
    const auto n = static_cast<std::size_t>(points);
    EXPECT_NEAR(thesis_sampling_error(22.0, n), error, 0.0005);
    EXPECT_NEAR(100.0 * thesis_relative_error(n), percent, 0.005);
  }
}

// Eq. 7 is the covering radius of RSID, as an arc: nothing that a radius is wrong by.
TEST(ThesisFormula, IsADistanceAlongTheSurface) {
  const Rsid scheme = Rsid::with_precision(0.1);
  EXPECT_NEAR(thesis_sampling_error(22.0, scheme.equator_points()), 22.0 * scheme.covering_radius(), 1e-7);
}

// A look-up without a table answers, bit for bit, what the table would.
TEST(SmoothRadius, IsThatOfTheTable) {
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(3.0);
    RadialTable<S> table(scheme);
    for (std::size_t i = 0; i < scheme.size(); ++i) table.radii()[i] = ball_radius(scheme.direction(i));
    for (const Vec3& u : uniform_directions(2000, 31)) {
      ASSERT_EQ(smooth_radius(scheme, u, [&](std::size_t i) { return ball_radius(scheme.direction(i)); }),
                table.radius_at(u))
          << S::name;
    }
  });
}

// By central differences.
TEST(SlantedPlane, SlopeIsTheGradient) {
  const SlantedPlane plane;
  constexpr double h = 1e-5;
  for (const Vec3& u : uniform_directions(2000, 41)) {
    if (!plane.covers(u)) continue;
    EXPECT_NEAR(plane.radius(u) * u.dot(plane.normal), plane.distance, 1e-11);
    const Vec3 east = u.unitOrthogonal();
    const auto along = [&](const Vec3& t) {
      return (plane.radius((u + h * t).normalized()) - plane.radius((u - h * t).normalized())) /
             (2.0 * std::atan(h));
    };
    const double expected = plane.radius(u) * plane.slope(u);
    ASSERT_NEAR(std::hypot(along(east), along(u.cross(east))), expected, 1e-6 * (1.0 + expected));
  }
}

// A plane's errors: their root mean square in mm, and the largest as a share of its bound.
struct PlaneError {
  double rms = 0.0;
  double share = 0.0;
};

template <SamplingScheme S>
PlaneError errors_along(const std::vector<Vec3>& directions, const S& scheme) {
  const SlantedPlane plane;
  PlaneError found;
  double squares = 0.0;
  double count = 0.0;
  for (const Vec3& u : directions) {
    if (!plane.covers(u)) continue;
    const double error = error_on_plane(plane, scheme, u);
    squares += error * error;
    count += 1.0;
    found.share = std::max(found.share, error / planar_bound(plane, scheme, u, scheme.covering_radius()));
  }
  found.rms = std::sqrt(squares / count);
  return found;
}

// Schemes whose taps are the corners of a cell no wider than its covering circle.
const std::set<std::string_view> kCells{"rsid",      "cube_gnomonic",        "cube_equiangular",
                                        "fibonacci", "icosahedral_gnomonic", "icosahedral_sine"};

// They keep the promise, and errors fall by four where the precision is halved.
TEST(SamplingError, OnAPlaneIsOfSecondOrder) {
  std::size_t checked = 0;
  for_each_scheme([&]<class S>() {
    if (!kCells.contains(S::name)) return;
    ++checked;
    std::vector<double> rms;
    for (const double precision : {2.0, 1.0, 0.5}) {
      const S scheme = S::with_precision(precision);
      const PlaneError everywhere = errors_along(uniform_directions(20000, 52), scheme);
      const PlaneError at_poles = errors_along(polar_directions(3.0 * precision * kDegree, 2000), scheme);
      const double share = std::max(everywhere.share, at_poles.share);
      EXPECT_LE(share, 1.0) << S::name;
      EXPECT_GT(share, 0.5) << S::name << ": the bound is loose";
      rms.push_back(everywhere.rms);
    }
    for (const std::size_t k : {0U, 1U}) EXPECT_NEAR(std::log2(rms[k] / rms[k + 1]), 2.0, 0.1) << S::name;
  });
  EXPECT_EQ(checked, kCells.size());
}

// Where rows end in a pole, their taps bend round it: an arc of few entries misses the pole's tangent by a
// share of its own length, so that the error there is of first order on a surface that is not level.
TEST(SamplingError, OfRowsAtAPoleIsOfFirstOrder) {
  const SlantedPlane plane;
  const auto largest = [&]<class S>(const S& scheme) {
    double error = 0.0;
    for (const Vec3& u : polar_directions(3.0 * scheme.covering_radius(), 4000))
      if (plane.covers(u)) error = std::max(error, error_on_plane(plane, scheme, u));
    return error;
  };
  const double order_rows =
      std::log2(largest(LatitudeRows::with_precision(1.0)) / largest(LatitudeRows::with_precision(0.5)));
  EXPECT_NEAR(order_rows, 1.0, 0.1);
  const double order_grid =
      std::log2(largest(Rsid::with_precision(1.0)) / largest(Rsid::with_precision(0.5)));
  EXPECT_NEAR(order_grid, 2.0, 0.1);
}

}  // namespace
}  // namespace impinge::lab
