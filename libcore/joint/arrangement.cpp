// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/arrangement.hpp"

#include <cmath>
#include <vector>

#include "sampling/exact_raster.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge {
namespace {

constexpr double kLookingPrecision = 4.0;  // degrees
constexpr double kMostOfThem = 0.7;        // of the common directions
constexpr double kClearlyLateral = 0.25;   // of the length of the mean direction

}  // namespace

bool look_swapped(const TriangleMesh& ball, const TriangleMesh& socket) {
  const Rsid scheme = Rsid::with_precision(kLookingPrecision);
  const RadialTable<Rsid> of_ball = fill_exact(ball, scheme, Layer::farthest);
  const RadialTable<Rsid> of_socket = fill_exact(socket, scheme, Layer::nearest);
  double ball_covers = 0.0;
  double socket_covers = 0.0;
  double common = 0.0;
  double outside = 0.0;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const Vec3 u = scheme.direction(i);
    const double area = std::hypot(u.x(), u.y());  // of the entry's patch, up to a factor
    const double gap = of_socket.radius_of(i) - of_ball.radius_of(i);
    if (!std::isnan(of_ball.radius_of(i))) ball_covers += area;
    if (!std::isnan(of_socket.radius_of(i))) socket_covers += area;
    if (!std::isnan(gap)) common += area;
    if (gap < 0.0) outside += area;
  }
  return ball_covers < socket_covers && outside > kMostOfThem * common;
}

bool looks_lateral(const TriangleMesh& socket, Side side) {
  const std::vector<double> area = vertex_areas(socket);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Vec3& x = socket.vertices[i];
    if (x.norm() > 0.0) mean += area[i] / x.norm() * x;
  }
  const double lateral = side == Side::right ? mean.x() : -mean.x();
  return lateral > kClearlyLateral * mean.norm();
}

}  // namespace impinge
