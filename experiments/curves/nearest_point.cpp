// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/nearest_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
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
  last_ = {static_cast<int>(cubes.x()) - 1, static_cast<int>(cubes.y()) - 1, static_cast<int>(cubes.z()) - 1};
  start_.assign(static_cast<std::size_t>(cubes.prod()) + 1, 0);
  const auto number_of = [this](const Vec3& p) {
    const Cube cube = cube_of(p);
    return number(cube.x, cube.y, cube.z);
  };
  for (const Vec3& p : points) ++start_[number_of(p) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(points.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) order_[next[number_of(points[i])]++] = i;
}

// Beyond all cubes within `reach` of its own, every point is at least reach * side away.
std::size_t NearestPoint::operator()(const Vec3& x) const {
  const Cube own = cube_of(x);
  const int farthest = std::max({last_.x, last_.y, last_.z});
  Best best{0, std::numeric_limits<double>::infinity()};
  for (int reach = 0; reach <= farthest; ++reach) {
    search_shell(own, reach, x, best);
    if (best.square <= (reach * side_) * (reach * side_)) break;
  }
  return best.point;
}

// The cubes `reach` away from x's own in one direction at least: whole rows on four sides, else two ends.
void NearestPoint::search_shell(const Cube& own, int reach, const Vec3& x, Best& best) const {
  for (int k = std::max(own.z - reach, 0); k <= std::min(own.z + reach, last_.z); ++k) {
    for (int j = std::max(own.y - reach, 0); j <= std::min(own.y + reach, last_.y); ++j) {
      const bool side = std::max(std::abs(k - own.z), std::abs(j - own.y)) == reach;
      for (int i = own.x - reach; i <= own.x + reach; i += side ? 1 : 2 * reach) {
        if (i >= 0 && i <= last_.x) search(number(i, j, k), x, best);
      }
    }
  }
}

void NearestPoint::search(std::size_t cube, const Vec3& x, Best& best) const {
  for (std::size_t n = start_[cube]; n < start_[cube + 1]; ++n) {
    const std::size_t point = order_[n];
    const double* p = points_[point].data();
    const double square =
        (p[0] - x[0]) * (p[0] - x[0]) + (p[1] - x[1]) * (p[1] - x[1]) + (p[2] - x[2]) * (p[2] - x[2]);
    if (square < best.square || (square == best.square && point < best.point)) best = {point, square};
  }
}

NearestPoint::Cube NearestPoint::cube_of(const Vec3& x) const {
  const auto along = [this](double offset, int last) {
    return static_cast<int>(std::clamp(std::floor(offset / side_), 0.0, static_cast<double>(last)));
  };
  return {along(x.x() - lowest_.x(), last_.x), along(x.y() - lowest_.y(), last_.y),
          along(x.z() - lowest_.z(), last_.z)};
}

std::size_t NearestPoint::number(int x, int y, int z) const {
  const auto wide = static_cast<std::size_t>(last_.x) + 1;
  const auto deep = static_cast<std::size_t>(last_.y) + 1;
  return (static_cast<std::size_t>(z) * deep + static_cast<std::size_t>(y)) * wide +
         static_cast<std::size_t>(x);
}

}  // namespace impinge
