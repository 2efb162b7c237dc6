// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/sphere_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace impinge {
namespace {

constexpr int kMostSteps = 100;
constexpr double kConverged = 1e-13;  // last step, as a share of the radius
constexpr double kSettled = 1e-6;     // a last step above this has found nothing
constexpr double kFlat = 1e-10;       // smallest over largest variance of points in a plane
constexpr int kMostRefinements = 50;

struct Weighted {
  std::span<const Vec3> points;
  std::span<const double> weight;
  double at(std::size_t i) const { return weight.empty() ? 1.0 : weight[i]; }
};

// The algebraic fit: |x|^2 - 2 c.x - k = 0 in the least squares sense, about the mean for the sake of
// rounding.
SphereFit algebraic_fit(const Weighted& data) {
  double total = 0.0;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    total += data.at(i);
    mean += data.at(i) * data.points[i];
  }
  mean /= total;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  double mean_square = 0.0;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Vec3 x = data.points[i] - mean;
    spread += data.at(i) * x * x.transpose();
    right += data.at(i) * x.squaredNorm() * x;
    mean_square += data.at(i) * x.squaredNorm();
  }
  const Vec3 variance = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  if (!(variance[0] > kFlat * variance[2])) {
    throw std::invalid_argument("a sphere cannot be fitted to points that lie in a plane");
  }
  const Vec3 offset = 0.5 * spread.ldlt().solve(right);
  return {mean + offset, std::sqrt(mean_square / total + offset.squaredNorm()), 0.0, data.points.size()};
}

// One Gauss-Newton step; returns its length relative to the radius and leaves the rms of the state before it.
double improve(const Weighted& data, SphereFit& fit) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Vec3 arm = data.points[i] - fit.centre;
    const double length = arm.norm();
    if (length == 0.0) continue;
    Eigen::Vector4d gradient;
    gradient << arm / length, 1.0;
    normal += data.at(i) * gradient * gradient.transpose();
    right += data.at(i) * (length - fit.radius) * gradient;
  }
  const Eigen::Vector4d step = normal.ldlt().solve(right);
  fit.centre += step.head<3>();
  fit.radius += step[3];
  return step.norm() / fit.radius;
}

double rms(const Weighted& data, const SphereFit& fit) {
  double total = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const double residual = (data.points[i] - fit.centre).norm() - fit.radius;
    total += data.at(i);
    sum += data.at(i) * residual * residual;
  }
  return std::sqrt(sum / total);
}

// The sphere through four points, if they are not in a plane.
std::optional<SphereFit> sphere_through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Eigen::Matrix3d arms;
  arms << (b - a).transpose(), (c - a).transpose(), (d - a).transpose();
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(arms);
  if (!lu.isInvertible()) return std::nullopt;
  const Vec3 offset =
      lu.solve(0.5 * Vec3((b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm()));
  return SphereFit{a + offset, offset.norm(), 0.0, 4};
}

// Area (mm^2) of the vertices within the tolerance, as a share of the sphere's: a large sphere that a few
// bumps touch does not win over a small one that is well covered.
double support(const TriangleMesh& mesh, std::span<const double> area, const SphereFit& trial,
               double tolerance) {
  double sum = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    if (std::abs((mesh.vertices[i] - trial.centre).norm() - trial.radius) <= tolerance * trial.radius)
      sum += area[i];
  }
  return sum / (trial.radius * trial.radius);
}

SphereFit best_trial(const TriangleMesh& mesh, std::span<const double> area, const BallFitOptions& options) {
  std::mt19937 random(options.seed);
  const auto pick = [&]() -> const Vec3& { return mesh.vertices[random() % mesh.vertices.size()]; };
  SphereFit best = fit_sphere(mesh.vertices, area);
  double most = support(mesh, area, best, options.start_tolerance);
  for (int k = 0; k < options.trials; ++k) {
    const Vec3& a = pick();
    const Vec3& b = pick();
    const Vec3& c = pick();
    const auto trial = sphere_through(a, b, c, pick());
    if (!trial) continue;
    const double votes = support(mesh, area, *trial, options.start_tolerance);
    if (votes > most) best = *trial, most = votes;
  }
  return best;
}

// Area (mm^2) of each vertex in faces whose outer side looks away from the centre. Orientation as a whole is
// not trusted: the side with more area counts as the outer one.
std::vector<double> outer_areas(const TriangleMesh& mesh, const Vec3& centre) {
  std::vector<double> out(mesh.vertices.size(), 0.0);
  std::vector<double> in(mesh.vertices.size(), 0.0);
  double balance = 0.0;
  for (const Face& face : mesh.faces) {
    const Vec3 area = area_vector(mesh, face) / 6.0;
    const bool away = area.dot(corner(mesh, face, 0) - centre) > 0.0;
    balance += away ? area.norm() : -area.norm();
    for (const VertexIndex v : face) (away ? out : in)[v] += area.norm();
  }
  return balance >= 0.0 ? out : in;
}

}  // namespace

SphereFit fit_sphere(std::span<const Vec3> points, std::span<const double> weight) {
  if (points.size() < 4) throw std::invalid_argument("a sphere is fitted to at least four points");
  const Weighted data{points, weight};
  SphereFit fit = algebraic_fit(data);
  double step = 1.0;
  for (int k = 0; k < kMostSteps && step > kConverged; ++k) step = std::abs(improve(data, fit));
  if (!(step < kSettled && fit.radius > 0.0)) {
    throw std::invalid_argument("no sphere fits the points: they do not bend round a centre");
  }
  fit.rms = rms(data, fit);
  return fit;
}
SphereFit fit_ball(const TriangleMesh& mesh, const BallFitOptions& options) {
  SphereFit fit = best_trial(mesh, vertex_areas(mesh), options);
  double tolerance = options.start_tolerance;
  std::vector<std::size_t> chosen;
  for (int k = 0; k < kMostRefinements; ++k) {
    const std::vector<double> area = outer_areas(mesh, fit.centre);
    std::vector<std::size_t> inside;
    std::vector<Vec3> points;
    std::vector<double> weight;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const double residual = (mesh.vertices[i] - fit.centre).norm() - fit.radius;
      if (area[i] == 0.0 || std::abs(residual) > tolerance * fit.radius) continue;
      inside.push_back(i);
      points.push_back(mesh.vertices[i]);
      weight.push_back(area[i]);
    }
    if (inside == chosen && tolerance == options.trim) break;
    fit = fit_sphere(points, weight);
    chosen = std::move(inside);
    tolerance = options.trim;
  }
  return fit;
}

}  // namespace impinge
