// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/sphere_fit.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace impinge {
namespace {

constexpr int kMostSteps = 100;
constexpr double kConverged = 1e-13;  // last step, as a share of the radius
constexpr double kSettled = 1e-6;     // a last step above this has found nothing
constexpr double kFlat = 1e-10;       // smallest over largest variance of points in a plane

struct Weighted {
  std::span<const Vec3> points;
  std::span<const double> weight;
  double at(std::size_t i) const { return weight.empty() ? 1.0 : weight[i]; }
};

// The algebraic fit: solves |x|^2 - 2 c.x - k = 0 by least squares, relative to the mean to limit rounding.
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
  SphereFit fit;
  fit.centre = mean + offset;
  fit.radius = std::sqrt(mean_square / total + offset.squaredNorm());
  fit.points = data.points.size();
  return fit;
}

// One Gauss-Newton step. Returns its length relative to the radius.
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

}  // namespace impinge
