// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 7:  sqrt(2) pi r / n        Eq. 8:  sqrt(2) pi / n
// One plane:  |error| <= rho^2 / 2 * max r (1 + 2 tan^2 psi)   for taps within a circle of radius rho
// An edge:    + rho / 2 * r^2 |q1 - q2|
#include "04_sampling_error/sampling_error.hpp"

#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "04_sampling_error/nearest_entry.hpp"
#include "sphere/scheme_list.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

const Vec3 kSlanted = Vec3(0.48, 0.6, 0.64);
constexpr double kRounding = 1e-12;  // mm

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

TEST(SamplingError, OfTheNearestEntryIsBoundedAndTheBoundIsReached) {
  const RadialSurface sphere = spherical_surface("sphere", 22.0, 5.0 * kSlanted);
  const Rsid scheme = Rsid::with_precision(1.0);
  const NearestEntryFinder<Rsid> finder(scheme);
  double share = 0.0;
  for (const Vec3& u : uniform_directions(20000, 51)) {
    const Vec3 v = scheme.direction(finder(u).entry);
    const double error = std::abs(sphere.radius(v) - sphere.radius(u));
    const double bound = nearest_bound(sphere, u, v);
    ASSERT_LE(error, bound * (1.0 + 1e-6) + kRounding);
    share = std::max(share, error / bound);
  }
  EXPECT_GT(share, 0.999);
}

// A plane's errors: their root mean square in mm, and the largest as a share of its bound.
struct PlaneError {
  double rms = 0.0;
  double share = 0.0;
};

template <SamplingScheme S>
PlaneError error_on_plane(const std::vector<Vec3>& directions, const S& scheme) {
  const RadialSurface plane = planar_surface("plane", kSlanted, 22.0, 75.0);
  PlaneError found;
  double squares = 0.0;
  double count = 0.0;
  for (const Vec3& u : directions) {
    if (!plane.covers(u)) continue;
    const double radius =
        smooth_radius(scheme, u, [&](std::size_t i) { return plane.radius(scheme.direction(i)); });
    const double error = std::abs(radius - plane.radius(u));
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
      const PlaneError everywhere = error_on_plane(uniform_directions(20000, 52), scheme);
      const PlaneError at_poles = error_on_plane(polar_directions(3.0 * precision * kDegree, 2000), scheme);
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
  const RadialSurface plane = planar_surface("plane", kSlanted, 22.0, 75.0);
  const auto largest = [&]<class S>(const S& scheme) {
    double error = 0.0;
    for (const Vec3& u : polar_directions(3.0 * scheme.covering_radius(), 4000)) {
      if (!plane.covers(u)) continue;
      const double radius =
          smooth_radius(scheme, u, [&](std::size_t i) { return plane.radius(scheme.direction(i)); });
      error = std::max(error, std::abs(radius - plane.radius(u)));
    }
    return error;
  };
  const double order_rows =
      std::log2(largest(LatitudeRows::with_precision(1.0)) / largest(LatitudeRows::with_precision(0.5)));
  EXPECT_NEAR(order_rows, 1.0, 0.1);
  const double order_grid =
      std::log2(largest(Rsid::with_precision(1.0)) / largest(Rsid::with_precision(0.5)));
  EXPECT_NEAR(order_grid, 2.0, 0.1);
}

TEST(SamplingError, AcrossAnEdgeIsBounded) {
  for (const double tilt : {0.0, 50.0}) {
    EdgeShape shape;
    shape.axis = kSlanted;
    shape.edge = kSlanted.cross(Vec3(0.8, 0.0, -0.6)).normalized();
    shape.dihedral_deg = 1.6;
    shape.tilt_deg = tilt;
    const EdgeSurface edge = edge_surface("edge", shape);
    for_each_scheme([&]<class S>() {
      const S scheme = S::with_precision(0.5);
      double share = 0.0;
      for (const Vec3& u : directions_along(shape, scheme.covering_radius(), 4000)) {
        const double radius =
            smooth_radius(scheme, u, [&](std::size_t i) { return edge.surface.radius(scheme.direction(i)); });
        const double error = std::abs(radius - edge.surface.radius(u));
        share = std::max(share, error / edge_bound(edge, scheme, u, scheme.stencil_radius()));
      }
      EXPECT_LE(share, 1.0) << S::name;
      // Entries of a scheme that is sparse elsewhere may lie denser here than its stencil radius says.
      if (kCells.contains(S::name)) {
        EXPECT_GT(share, 0.05) << S::name << ": the bound says nothing";
      }
    });
  }
}

TEST(Probes, AreThoseThatTheSurfaceCovers) {
  const RadialSurface plane = planar_surface("plane", kSlanted, 22.0, 60.0);
  const auto u = uniform_directions(1000, 54);
  const Probes probes = probes_of(plane, u);
  EXPECT_NEAR(static_cast<double>(probes.place.size()), 250.0, 50.0);
  const auto errors = errors_at(probes, [&](std::size_t k) { return plane.radius(u[k]) - 0.5; });
  for (const double error : errors) EXPECT_NEAR(error, 0.5, 1e-12);
  for (const std::size_t k : probes.place) EXPECT_LE(angle_between(u[k], kSlanted), 60.0 * kDegree);
}

}  // namespace
}  // namespace impinge::lab
