// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/radii_over_cap.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/surface_vertices.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {

RadiiOverCap::RadiiOverCap(const TriangleMesh& mesh, Layer layer)
    : layer_(layer), index_(without_edge_on(mesh), layer, kIndexReach), wide_(mesh, layer) {
  const TriangleMesh surface = without_edge_on(mesh);
  for (const Face& face : surface.faces) ranges_.push_back(face_cap(corners_of(surface, face)).range);
  for (const JumpEdge& edge : jump_edges(surface)) {
    const Vec3 from = surface.vertices[edge.from].normalized();
    const Vec3 to = surface.vertices[edge.to].normalized();
    const Vec3 middle = (from + to).stableNormalized();
    jumps_.push_back({from, to, middle, std::max(angle_between(middle, from), angle_between(middle, to))});
  }
}

// The bound from all faces near the cap: the least radius of the nearest layer, the largest of the farthest.
double RadiiOverCap::of_faces(const DirectionCap& cap) const {
  if (cap.radius + kCapSlack > kIndexReach)
    return static_cast<double>(wide_.within(cap.axis, std::nextafter(static_cast<float>(cap.radius), 4.0F)));
  index_.faces_near(cap, near_);
  RadiusRange all;
  for (const std::uint32_t f : near_) {
    const PlaneRange range = range_within(index_.plane(f), cap);
    all.low = std::min(all.low, std::max(range.least, ranges_[f].low));
    all.high = std::max(all.high, std::min(range.largest, ranges_[f].high));
  }
  return nearest() ? all.low * (1.0 - kOutwards) : all.high * (1.0 + kOutwards);
}

// May a jump edge meet the cap? An edge's arc is within its sagitta of the chord, so that distances from the
// chord are compared; this makes an edge count a little early.
bool RadiiOverCap::meets_jump(const DirectionCap& cap) const {
  return std::ranges::any_of(jumps_, [&cap](const Jump& jump) {
    if ((jump.middle - cap.axis).norm() > cap.radius + jump.angle + kCapSlack) return false;
    const double sagitta = 0.5 * jump.angle * jump.angle;
    const double distance = std::sqrt(squared_distance_to_segment(cap.axis, jump.from, jump.to));
    return distance <= cap.radius + sagitta + kCapSlack;
  });
}

// The other bound, from the sheet that the axis meets and that goes on over the cap.
double RadiiOverCap::of_sheet(const DirectionCap& cap) const {
  if (cap.radius + kCapSlack > kIndexReach || meets_jump(cap)) return none();
  const double middle = index_.radius(cap.axis);
  if (std::isnan(middle)) return none();
  index_.faces_near(cap, near_);
  RadiusRange all;
  double slope = 0.0;
  for (const std::uint32_t f : near_) {
    const PlaneRange range = range_within(index_.plane(f), cap);
    all.include(range.least);
    all.include(range.largest);
    slope = std::max(slope, range.slope);
  }
  const double growth = std::exp(std::min(slope * cap.radius, 100.0));
  return nearest() ? std::min(all.high, middle * growth) * (1.0 + kOutwards)
                   : std::max(all.low, middle / growth) * (1.0 - kOutwards);
}

}  // namespace impinge
