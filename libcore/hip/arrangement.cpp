// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

constexpr double kLookingPrecision = 4.0;  // degrees
constexpr double kMostOfThem = 0.7;        // of the common directions
constexpr double kClearlyLateral = 0.25;   // of the length of the mean direction

using Weighted = std::pair<double, double>;  // a value and its weight

double median(std::vector<Weighted> values, double total) {
  std::ranges::sort(values);
  double sum = 0.0;
  for (const auto& [value, weight] : values) {
    sum += weight;
    if (sum >= 0.5 * total) return value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Facing facing(const TriangleMesh& ball, const TriangleMesh& socket) {
  const Rsid scheme = Rsid::with_precision(kLookingPrecision);
  const RadialTable<Rsid> of_ball = fill_exact(ball, scheme, Layer::farthest);
  const RadialTable<Rsid> of_socket = fill_exact(socket, scheme, Layer::nearest);
  Facing found;
  found.nearest = std::numeric_limits<double>::infinity();
  std::vector<Weighted> radii;
  std::vector<Weighted> ratios;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const Vec3 u = scheme.direction(i);
    const double area = std::hypot(u.x(), u.y());  // of the entry's patch, up to a factor
    const double inner = of_ball.radius_of(i);
    const double outer = of_socket.radius_of(i);
    if (!std::isnan(inner)) found.ball_covers += area;
    if (!std::isnan(outer)) found.socket_covers += area;
    if (!std::isnan(inner)) radii.emplace_back(inner, area);
    if (std::isnan(inner) || std::isnan(outer)) continue;
    ratios.emplace_back(outer / inner, area);
    found.nearest = std::min(found.nearest, outer - inner);
    found.common += area;
    if (outer < inner) found.outside += area;
  }
  found.ball_radius = median(std::move(radii), found.ball_covers);
  found.ratio = median(std::move(ratios), found.common);
  return found;
}

bool look_swapped(const Facing& facing, bool cap) {
  return (cap || facing.ball_covers < facing.socket_covers) && facing.outside > kMostOfThem * facing.common;
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
