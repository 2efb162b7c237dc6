// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/radii_over_cap.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/surface_vertices.hpp"
#include "mesh/triangle_distance.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr double kIndexReach = 0.1;  // radians; wider caps are asked of the levels of limits
constexpr double kOutwards = 1e-9;   // of a radius

}  // namespace

RadiiOverCap::RadiiOverCap(const TriangleMesh& mesh)
    : index_(without_edge_on(mesh), Layer::nearest, kIndexReach), wide_(mesh, Layer::nearest) {
  const TriangleMesh surface = without_edge_on(mesh);
  for (const Face& face : surface.faces) least_.push_back(face_cap(corners_of(surface, face)).range.low);
  for (const JumpEdge& edge : jump_edges(surface)) {
    const Vec3 from = surface.vertices[edge.from].normalized();
    const Vec3 to = surface.vertices[edge.to].normalized();
    const Vec3 middle = (from + to).stableNormalized();
    jumps_.push_back({from, to, middle, std::max(angle_between(middle, from), angle_between(middle, to))});
  }
}

double RadiiOverCap::least(const DirectionCap& cap) const {
  if (cap.radius + kCapSlack > kIndexReach)
    return static_cast<double>(
        wide_.within(cap.axis, std::nextafter(static_cast<float>(cap.radius), 4.0F)).radius);
  index_.faces_near(cap, near_);
  double least = kInfinity;
  for (const std::uint32_t f : near_) {
    const double radius = std::max(range_within(index_.plane(f), cap).least, least_[f]);
    least = std::min(least, radius);
  }
  return least * (1.0 - kOutwards);
}

// A chord is no longer than its arc, and the straight line between the ends is no farther from a direction
// than the arc is: what it is nearer by, the square of its length, makes an edge count a little early.
bool RadiiOverCap::meets_jump(const DirectionCap& cap) const {
  return std::ranges::any_of(jumps_, [&cap](const Jump& jump) {
    if ((jump.middle - cap.axis).norm() > cap.radius + jump.angle + kCapSlack) return false;
    const double sagitta = 0.5 * jump.angle * jump.angle;
    const double distance = std::sqrt(squared_distance_to_segment(cap.axis, jump.from, jump.to));
    return distance <= cap.radius + sagitta + kCapSlack;
  });
}

double RadiiOverCap::largest(const DirectionCap& cap) const {
  if (cap.radius + kCapSlack > kIndexReach || meets_jump(cap)) return kInfinity;
  const double middle = index_.radius(cap.axis);
  if (std::isnan(middle)) return kInfinity;
  index_.faces_near(cap, near_);
  double largest = 0.0;
  double slope = 0.0;
  for (const std::uint32_t f : near_) {
    const PlaneRange range = range_within(index_.plane(f), cap);
    largest = std::max(largest, range.largest);
    slope = std::max(slope, range.slope);
  }
  const double grown = middle * std::exp(std::min(slope * cap.radius, 100.0));
  return std::min(largest, grown) * (1.0 + kOutwards);
}

}  // namespace impinge
