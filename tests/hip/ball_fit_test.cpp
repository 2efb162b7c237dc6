// SPDX-License-Identifier: GPL-3.0-or-later
// Contract of fit_ball(): the sphere of a ball is found though the mesh holds more than it. Where most of the
// head is a true sphere (generated hips), centre and radius come out to a thousandth of a millimetre,
// whatever cam, neck, shaft, rim or fossa there is; with noise of standard deviation s on every coordinate to
// a share of s. Real joints: tests/command/real_bones_test.cpp.
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/hip_surface.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/random_vector.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

const Vec3 kElsewhere(-86.0, -20.0, -580.0);

class PresetFit : public testing::TestWithParam<std::string_view> {};

TEST_P(PresetFit, FindsHeadAndSocket) {
  HipParameters p = hip_preset(GetParam());
  p.side = Side::right;
  const HipSurface surface = hip_surface(p);
  const Hip hip = make_hip(p, 6000);
  const SphereFit head = fit_ball(test::moved(hip.ball, kElsewhere));
  EXPECT_LT((head.centre - kElsewhere).norm(), 0.002);
  EXPECT_NEAR(head.radius, p.head_radius, 0.002);
  const SphereFit socket = fit_ball(test::moved(hip.socket, kElsewhere));
  EXPECT_LT((socket.centre - kElsewhere - surface.socket_centre).norm(), 0.002);
  EXPECT_NEAR(socket.radius, surface.socket_radius, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Every, PresetFit, testing::ValuesIn(hip_preset_names()),
                         [](const auto& name) { return std::string(name.param); });

// The neck's rounding is within the noise of the sphere and lies outside of it, so the bias is more than
// chance: half the noise is allowed.
TEST(BallFit, FindsTheHeadThroughNoise) {
  const Hip hip = make_hip(hip_preset("normal"), 6000);
  for (const double noise : {0.1, 0.3, 0.5}) {
    std::mt19937 random(7);
    std::normal_distribution<double> error(0.0, noise);
    TriangleMesh ball = hip.ball;
    for (Vec3& v : ball.vertices) v += test::random_vector(error, random);
    const SphereFit fit = fit_ball(ball);
    EXPECT_LT(fit.centre.norm(), 0.5 * noise);
    EXPECT_NEAR(fit.radius, 24.0, 0.5 * noise);
    EXPECT_NEAR(fit.rms, noise, 0.15 * noise);
  }
}

// A head on a long bone with a second, larger parameter, that is less of a sphere: an ellipsoid.
TEST(BallFit, FindsTheHeadOfALongBone) {
  const Hip hip = make_hip({.shaft_length = 200.0}, 6000);
  TriangleMesh parameter = sphere(30.0, 2000);
  for (Vec3& v : parameter.vertices) v = Vec3(1.3 * v.x(), v.y(), 0.8 * v.z()) + Vec3(40.0, 0.0, -250.0);
  const SphereFit fit = fit_ball(test::joined(hip.ball, parameter));
  EXPECT_LT(fit.centre.norm(), 0.002);
  EXPECT_NEAR(fit.radius, 24.0, 0.002);
}

TEST(BallFit, IsTheSameEveryTime) {
  const TriangleMesh ball = make_ball_socket_pair(3000).ball;
  const SphereFit first = fit_ball(ball);
  EXPECT_EQ(first.centre, fit_ball(ball).centre);
  EXPECT_LT(first.centre.norm(), 0.002) << "a cam of 3 mm does not pull the centre";
}

TEST(BallFit, OrientationDoesNotMatter) {
  TriangleMesh ball = make_hip({}, 3000).ball;
  const SphereFit outward = fit_ball(ball);
  for (Face& face : ball.faces) std::swap(face[0], face[1]);
  EXPECT_LT((fit_ball(ball).centre - outward.centre).norm(), 1e-3);
}

// The map of Figures 38 and 39: zero on the head, the cam's height on its top, more on the neck; the region
// holds the points of the fit and neither.
TEST(BallFit, DeviationsShowTheCam) {
  HipParameters p = hip_preset("cam");
  const HipSurface surface = hip_surface(p);
  const TriangleMesh ball = make_hip(p).ball;
  const SphereFit fit = fit_ball(ball);
  const std::vector<double> deviation = sphere_deviations(ball, fit);
  const std::vector<bool> region = spherical_region(ball, fit);
  const Vec3 top = clock_direction(surface.neck, surface.neck_clock, p.cam_polar * kDegree, p.cam_clock);
  std::size_t inside = 0;
  double highest = 0.0;
  for (std::size_t i = 0; i < deviation.size(); ++i) {
    const Vec3& v = ball.vertices[i];
    EXPECT_NEAR(deviation[i], v.norm() - p.head_radius, 0.004);
    inside += region[i] ? 1U : 0U;
    EXPECT_TRUE(!region[i] || std::abs(deviation[i]) < fit.trim + 1e-3);
    if (angle_between(v, top) < 5.0 * kDegree) highest = std::max(highest, deviation[i]);
  }
  EXPECT_NEAR(static_cast<double>(inside), static_cast<double>(fit.points),
              0.02 * static_cast<double>(fit.points));
  EXPECT_NEAR(highest, p.cam_height, 0.05);
}

TEST(BallFit, RefusesTooFewPointsAndPlanes) {
  EXPECT_THROW(fit_ball({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), std::invalid_argument);
  TriangleMesh flat;
  for (int k = 0; k < 30; ++k) flat.vertices.emplace_back(k, k % 2, 0.0);
  for (VertexIndex k = 0; k < 28; ++k) flat.faces.push_back({k, k + 1, k + 2});
  EXPECT_THROW(fit_ball(flat), std::invalid_argument);
}

// E(a, b, c, r) = sum (L_i - r)^2 is least (Eberly 1999): its gradient vanishes there and no neighbour is
// lower.

std::vector<Vec3> noisy_cap(const Vec3& centre, double radius, double noise, double lowest_z) {
  std::mt19937_64 random(50);
  std::normal_distribution<double> error(0.0, noise);
  std::vector<Vec3> points;
  for (const Vec3& u : test::random_directions(4000, 51)) {
    if (u.z() >= lowest_z) points.push_back(centre + (radius + error(random)) * u);
  }
  return points;
}

double energy(std::span<const Vec3> points, const Vec3& centre, double radius) {
  double sum = 0.0;
  for (const Vec3& x : points) sum += std::pow((x - centre).norm() - radius, 2);
  return sum;
}

TEST(SphereFit, IsExactOnASphere) {
  const Vec3 centre(-86.0, 20.0, -580.0);
  const auto points = noisy_cap(centre, 24.0, 0.0, -1.0);
  const SphereFit fit = fit_sphere(points);
  EXPECT_LT((fit.centre - centre).norm(), 1e-10);
  EXPECT_NEAR(fit.radius, 24.0, 1e-10);
  EXPECT_LT(fit.rms, 1e-10);
  EXPECT_EQ(fit.points, points.size());
}

// The standard error of the centre is about sigma sqrt(3 / n); five of them are allowed. A cap loses some.
TEST(SphereFit, FindsTheCentreThroughNoise) {
  const Vec3 centre(5.0, -3.0, 8.0);
  for (const double lowest : {-1.0, 0.0}) {
    const auto points = noisy_cap(centre, 24.0, 0.5, lowest);
    const SphereFit fit = fit_sphere(points);
    const double loss = lowest < 0.0 ? 1.0 : 4.0;
    EXPECT_LT((fit.centre - centre).norm(),
              loss * 5.0 * 0.5 * std::sqrt(3.0 / static_cast<double>(points.size())));
    EXPECT_NEAR(fit.rms, 0.5, 0.03);
  }
}

TEST(SphereFit, NoNeighbourHasALowerEnergy) {
  const auto points = noisy_cap({1.0, 2.0, 3.0}, 20.0, 1.0, 0.2);
  const SphereFit fit = fit_sphere(points);
  const double least = energy(points, fit.centre, fit.radius);
  for (const Vec3& u : test::random_directions(50, 52)) {
    for (const double step : {1e-4, 1e-2}) {
      EXPECT_GT(energy(points, fit.centre + step * u, fit.radius), least);
      EXPECT_GT(energy(points, fit.centre, fit.radius + step), least);
      EXPECT_GT(energy(points, fit.centre, fit.radius - step), least);
    }
  }
}

TEST(SphereFit, WeightsStandForRepeatedPoints) {
  auto points = noisy_cap({1.0, 2.0, 3.0}, 20.0, 1.0, 0.5);
  std::vector<double> weight(points.size(), 1.0);
  weight[3] = 3.0;
  weight[7] = 0.0;
  const SphereFit weighted = fit_sphere(points, weight);
  points.push_back(points[3]);
  points.push_back(points[3]);
  points.erase(points.begin() + 7);
  const SphereFit repeated = fit_sphere(points);
  EXPECT_LT((weighted.centre - repeated.centre).norm(), 1e-9);
}

TEST(SphereFit, RefusesTooFewPointsAndPlanes) {
  const std::vector<Vec3> three{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_THROW(fit_sphere(three), std::invalid_argument);
  std::vector<Vec3> flat;
  for (int k = 0; k < 50; ++k) flat.emplace_back(std::cos(k), std::sin(k), 0.0);
  EXPECT_THROW(fit_sphere(flat), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
