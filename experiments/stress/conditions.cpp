// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/conditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "stress/methods.hpp"

namespace impinge::lab {
namespace {

using Long = long double;
using LongVec = Eigen::Matrix<Long, 3, 1>;

constexpr Long kSamePlace = 1e-4L;  // of the radius: faces that meet at an edge or vertex

double finite(Long value) {
  const auto rounded = static_cast<double>(value);
  return std::isfinite(rounded) ? rounded : std::numeric_limits<double>::max();
}

struct LongPlane {
  explicit LongPlane(const TriangleCone& cone) {
    const LongVec a = cone.corners()[0].cast<Long>();
    const LongVec b = cone.corners()[1].cast<Long>();
    const LongVec c = cone.corners()[2].cast<Long>();
    normal = (b - a).cross(c - a);
    offset = std::abs(normal.dot(a));
  }
  Long radius(const LongVec& u) const { return offset / std::abs(normal.dot(u)); }
  double slope(const LongVec& u) const { return finite(normal.cross(u).norm() / std::abs(normal.dot(u))); }

  LongVec normal;
  Long offset = 0.0L;
};

}  // namespace

std::vector<RayCondition> conditions_along(const TriangleMesh& mesh, std::span<const Vec3> directions) {
  std::vector<TriangleCone> cones;
  std::vector<LongPlane> planes;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    cones.push_back(cone);
    planes.emplace_back(cone);
  }
  std::vector<RayCondition> found;
  std::vector<std::size_t> met;
  for (const Vec3& direction : directions) {
    const Vec3 unit = direction.stableNormalized();
    const LongVec u = direction.cast<Long>().normalized();
    met.clear();
    Long nearest = std::numeric_limits<Long>::infinity();
    for (std::size_t f = 0; f < cones.size(); ++f) {
      if (!is_met(cones[f], direction, unit)) continue;
      met.push_back(f);
      nearest = std::min(nearest, planes[f].radius(u));
    }
    RayCondition here;
    for (const std::size_t f : met) {
      if (planes[f].radius(u) > nearest * (1.0L + kSamePlace)) continue;
      here.slope = std::max(here.slope, planes[f].slope(u));
    }
    found.push_back(here);
  }
  return found;
}

double stiffness(const TriangleMesh& mesh) {
  std::vector<double> slopes;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    const auto& [a, b, c] = cone.corners();
    slopes.push_back(LongPlane(cone).slope((a + b + c).cast<Long>().normalized()));
  }
  if (slopes.empty()) return 0.0;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::ranges::nth_element(slopes, middle);
  const double median = *middle;
  return *std::ranges::max_element(slopes) / std::max(median, 1e-16);
}

}  // namespace impinge::lab
