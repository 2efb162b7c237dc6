// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/nearest_point.hpp"

#include <limits>
#include <stdexcept>

namespace impinge {
namespace {

constexpr double kMostCubes = 16777216.0;

}  // namespace

NearestPoint::NearestPoint(std::span<const Vec3> points, double side) : points_(points), side_(side) {
  if (points.empty()) throw std::invalid_argument("there is no nearest point among none");
  lowest_ = points.front();
  Vec3 highest = points.front();
  for (const Vec3& p : points) {
    lowest_ = lowest_.cwiseMin(p);
    highest = highest.cwiseMax(p);
  }
  const Vec3 cubes = ((highest - lowest_) / side).array().floor() + 1.0;
  if (!(side > 0.0 && cubes.prod() <= kMostCubes)) {
    throw std::invalid_argument(
        "the cubes of a nearest-point grid have a side above 0 that is not too small");
  }
  last_ = cubes.cast<int>().array() - 1;
  start_.assign(static_cast<std::size_t>(cubes.prod()) + 1, 0);
  for (const Vec3& p : points) ++start_[number(cube_of(p)) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(points.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) order_[next[number(cube_of(points[i]))]++] = i;
}

// Beyond all cubes within `reach` of its own, every point is at least reach * side away.
std::size_t NearestPoint::operator()(const Vec3& x) const {
  const Cube own = cube_of(x);
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int reach = 0; reach <= last_.maxCoeff(); ++reach) {
    const Cube from = (own.array() - reach).max(0);
    const Cube to = (own.array() + reach).min(last_.array());
    for (int k = from.z(); k <= to.z(); ++k) {
      for (int j = from.y(); j <= to.y(); ++j) {
        for (int i = from.x(); i <= to.x(); ++i) {
          if ((Cube(i, j, k) - own).cwiseAbs().maxCoeff() < reach) continue;
          const std::size_t cube = number({i, j, k});
          for (std::size_t n = start_[cube]; n < start_[cube + 1]; ++n) {
            const double square = (points_[order_[n]] - x).squaredNorm();
            if (square < nearest || (square == nearest && order_[n] < best)) {
              nearest = square;
              best = order_[n];
            }
          }
        }
      }
    }
    if (nearest <= reach * side_ * reach * side_) break;
  }
  return best;
}

NearestPoint::Cube NearestPoint::cube_of(const Vec3& x) const {
  const Vec3 at = ((x - lowest_) / side_).array().floor();
  return at.cwiseMax(0.0).cwiseMin(last_.cast<double>()).cast<int>();
}

std::size_t NearestPoint::number(const Cube& cube) const {
  const auto wide = static_cast<std::size_t>(last_.x() + 1);
  const auto deep = static_cast<std::size_t>(last_.y() + 1);
  return (static_cast<std::size_t>(cube.z()) * deep + static_cast<std::size_t>(cube.y())) * wide +
         static_cast<std::size_t>(cube.x());
}

}  // namespace impinge
