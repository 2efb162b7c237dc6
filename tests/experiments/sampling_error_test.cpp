// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 7:  sqrt(2) pi r / n        Eq. 8:  sqrt(2) pi / n
// One plane:  |error| <= rho^2 / 2 * max r (1 + 2 tan^2 psi)   for taps within a circle of radius rho
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "04_error_budget/error_budget.hpp"
#include "04_sampling_error/sampling_study.hpp"
#include "10_euclidean/distance_study.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
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

BudgetJoint generated() {
  const PairShape shape;
  return {"generated", make_ball_socket_pair(3000, shape), Vec3(0.1, -0.2, 0.05), [shape](const Vec3& u) {
            return angle_between(u, Vec3::UnitZ()) > shape.half_opening_deg * kDegree ? kNoSurface
                                                                                      : shape.socket_radius;
          }};
}

// The faces of a sphere's mesh lie inside of it, by the sagitta at most.
TEST(ErrorBudget, MeshStageIsTheSagittaOfTheFaces) {
  const BudgetJoint joint = generated();
  const std::vector<Stage> stages = exact_stages(joint);
  ASSERT_EQ(stages.at(1).adds, "mesh");
  double largest = 0.0;
  for (std::size_t i = 0; i < stages[0].gap.size(); ++i)
    largest = std::fmax(largest, std::abs(stages[1].gap[i] - stages[0].gap[i]));
  const std::vector<double> sagittas = face_sagittas(joint.meshes.socket);
  const double estimate = *std::ranges::max_element(sagittas);
  EXPECT_GT(largest, 0.3 * estimate);
  EXPECT_LT(largest, 1.05 * estimate);
}

// Off by e, concentric spheres of radii B and S are both seen e.u nearer: of the gap only e_t^2 / 2 (1 / B -
// 1 / S) is left, e_t the part of e across the ray. Faces seen obliquely add what is of first order and has
// either sign: the mean over all vertices is that of the spheres. The socket is far from the ball and the
// faces are small, so that the spheres' part, 12 um at 1 mm, is far above what the faces leave of theirs in
// the mean.
// Every seventh vertex is enough: the mean changes by 0.4 %.
struct MeanChange {
  double measured = 0.0;
  double spheres = 0.0;
};

MeanChange mean_change(double off) {
  PairShape shape;
  shape.cam_height = 0.0;
  shape.head_radius = 20.0;
  shape.socket_radius = 80.0;
  BudgetJoint joint{"spheres", make_ball_socket_pair(12000, shape), off * Vec3(0.48, 0.6, 0.64), {}};
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < joint.meshes.ball.vertices.size(); i += 7)
    some.push_back(joint.meshes.ball.vertices[i]);
  joint.meshes.ball.vertices = some;
  const std::vector<Stage> stages = exact_stages(joint);
  MeanChange mean;
  double count = 0.0;
  for (std::size_t i = 0; i < joint.meshes.ball.vertices.size(); ++i) {
    const double change = stages.at(1).gap[i] - stages.at(0).gap[i];
    if (std::isnan(change)) continue;
    const double across = joint.wrong_centre.cross(joint.meshes.ball.vertices[i].normalized()).squaredNorm();
    mean.measured += change;
    mean.spheres += 0.5 * across * (1.0 / shape.head_radius - 1.0 / shape.socket_radius);
    count += 1.0;
  }
  mean.measured /= count;
  mean.spheres /= count;
  return mean;
}

TEST(ErrorBudget, CentreStageIsOfSecondOrderForConcentricSpheres) {
  const MeanChange near = mean_change(1.0);
  const MeanChange far = mean_change(2.0);
  EXPECT_NEAR(std::log2(far.measured / near.measured), 2.0, 0.1);
  EXPECT_NEAR(near.measured / near.spheres, 1.0, 0.05);
}

TEST(FaceSagittas, AreThoseOfASphere) {
  const TriangleMesh sphere = icosphere(25.0, 3);
  const std::vector<double> sagittas = face_sagittas(sphere);
  for (std::size_t f = 0; f < sphere.faces.size(); ++f) {
    const Vec3& a = sphere.vertices[sphere.faces[f][0]];
    const Vec3& b = sphere.vertices[sphere.faces[f][1]];
    const Vec3& c = sphere.vertices[sphere.faces[f][2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double exact = 25.0 - normal.dot(a);  // from the circumcentre to the sphere
    EXPECT_GT(sagittas[f], 0.9 * exact);
    EXPECT_LT(sagittas[f], 1.6 * exact);
  }
}

// Closed forms: about its own centre a sphere is faced squarely and gap and distance are one; outside a plane
// met at psi the gap is 1 / cos psi times the distance.

TEST(DistanceStudy, ASphereIsFacedSquarely) {
  const TriangleMesh ball = sphere(26.0, 4000);
  const auto shares = distance_shares(ball, sphere(22.0, 200).vertices);
  ASSERT_EQ(shares.size(), 4U);
  EXPECT_EQ(shares[0].zone, "facing");
  EXPECT_EQ(shares[0].gap.size(), 102U);
  for (const double ratio : shares[0].gap) EXPECT_NEAR(ratio, 1.0, 0.01);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_TRUE(shares[k].gap.empty());
}

TEST(DistanceStudy, AnglesAndRimsSetPointsApart) {
  const TriangleMesh plane{{{40, -20, 10}, {0, 80, 10}, {-40, -20, 10}}, {{0, 1, 2}}};
  const double psi = std::acos(1.0 / std::sqrt(3.0));
  const Vec3 off(9.0, -9.95, 5.0);  // whose ray ends just inside the side y = -20
  const auto found = distance_shares(plane, std::vector<Vec3>{{0, 0, 9.5}, {9, 9, 9}, off});
  ASSERT_EQ(found[0].gap.size(), 1U);
  EXPECT_NEAR(found[0].gap[0], 1.0, 1e-12);
  ASSERT_EQ(found[2].gap.size(), 1U);
  EXPECT_NEAR(found[2].gap[0], 1.0 / std::cos(psi), 1e-12);
  ASSERT_EQ(found[3].gap.size(), 1U);
  EXPECT_NEAR(found[3].gap[0], off.norm() / 5.0, 1e-12) << "the gap is |x|, the plane is 5 mm above";
}

}  // namespace
}  // namespace impinge::lab
