// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/holding_triangle.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace impinge {
namespace {

/// Volume a . (b x c), from differences, so that it is accurate for neighbouring entries too.
double volume(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot((b - a).cross(c - a)); }

}  // namespace

HoldingTriangle holding_triangle(std::span<const Vec3> entries, const Vec3& u) {
  constexpr double kRounding = 2e-15;   // of the height of an entry above a plane
  constexpr double kLeastShare = 1e-5;  // less than that would leave a flat triangle
  constexpr double kShort = 0.1;        // length of the vectors to start from, which entries soon replace
  constexpr int kMostSteps = 64;
  const Vec3 east = u.unitOrthogonal();
  const Vec3 north = u.cross(east);
  const double half = 0.5 * std::sqrt(3.0);
  std::array<Vec3, 3> corner{kShort * (u + east), kShort * (u - 0.5 * east + half * north),
                             kShort * (u - 0.5 * east - half * north)};
  const auto volumes = [&corner](const Vec3& x) {  // barycentric coordinates of x, but for a factor
    return std::array<double, 3>{volume(x, corner[1], corner[2]), volume(x, corner[2], corner[0]),
                                 volume(x, corner[0], corner[1])};
  };
  HoldingTriangle found;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    double highest = kRounding * normal.norm();
    std::size_t enter = entries.size();
    for (std::size_t j = 0; j < entries.size(); ++j) {
      const double height = normal.dot(entries[j] - corner[0]);
      if (height > highest) {
        highest = height;
        enter = j;
      }
    }
    if (enter == entries.size()) break;
    const std::array<double, 3> weight = volumes(u);
    const std::array<double, 3> share = volumes(entries[enter]);
    const double least = kLeastShare * normal.dot(corner[0]);
    std::size_t leave = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      if (share[k] > least && (leave == 3 || weight[k] * share[leave] < weight[leave] * share[k])) leave = k;
    }
    if (leave == 3) break;  // not for finite directions
    corner[leave] = entries[enter];
    found.place[leave] = enter;
  }
  found.weight = volumes(u);
  for (double& w : found.weight) w = std::max(w, 0.0);
  const double sum = found.weight[0] + found.weight[1] + found.weight[2];
  for (double& w : found.weight) w /= sum;
  return found;
}

}  // namespace impinge
