// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre, and how far from it, the nearest layer of a surface is over a cap of directions, or
// the farthest: ends that close on the radius as the cap narrows. Of the nearest layer:
//
// Least. Of each face that may meet the cap no radius is below d / cos(psi - angle), d the distance of its
// plane and psi the angle from the cap's axis to its normal, nor below min (a . v) over its corners v, a
// their mean direction, since a . x <= |x| is linear. The least of all faces is a lower end, and an infinite
// one where there is none.
//
// Largest. If the axis is covered, at radius r, and no jump edge (mesh/jump_edges.hpp) meets the cap, then
// the sheet that is nearest there goes on over the whole cap, from face to face, and the nearest layer is
// nowhere beyond it. On the way its radius changes by exp(+- angle T) at most, T the largest tan psi of the
// faces near, and is no larger than theirs. Otherwise nothing is said.
//
// Of the farthest layer largest and least change places: no face has a radius above d / cos(psi + angle), nor
// above that of its farthest corner, and a sheet that goes on over the whole cap is not beyond that layer.
#pragma once

#include <vector>

#include "contact/cap_limits.hpp"
#include "mesh/jump_edges.hpp"
#include "sphere/infinity.hpp"
#include "table/surface_index.hpp"

namespace impinge {

/// Of questions over caps: radians, of the widest that is asked of faces; wider ones are asked of CapLimits.
inline constexpr double kIndexReach = 0.1;
/// By what share of a radius their answers are rounded outwards.
inline constexpr double kOutwards = 1e-9;

/// Of one layer; numbers in double, rounded outwards. A direction without a surface has an infinite radius
/// where the layer is the nearest, and -infinity where it is the farthest.
class RadiiOverCap {
 public:
  /// mesh in the centre frame, mm. Faces whose plane holds the centre cover no direction and are left out.
  RadiiOverCap(const TriangleMesh& mesh, Layer layer);

  /// No direction of the cap has a smaller radius, mm.
  double least(const DirectionCap& cap) const { return nearest() ? of_faces(cap) : of_sheet(cap); }
  /// No direction of the cap has a larger radius, mm.
  double largest(const DirectionCap& cap) const { return nearest() ? of_sheet(cap) : of_faces(cap); }
  /// Radius along unit u, mm, NaN where nothing is met.
  double radius(const Vec3& u) const { return index_.radius(u); }

 private:
  /// A jump edge, as the centre sees it.
  struct Jump {
    Vec3 from;     // unit vector to an end
    Vec3 to;       // unit vector to the other
    Vec3 middle;   // unit vector between
    double angle;  // radians, from the middle to the ends
  };
  bool nearest() const { return layer_ == Layer::nearest; }
  double none() const { return nearest() ? kInfinity : -kInfinity; }
  double of_faces(const DirectionCap& cap) const;
  double of_sheet(const DirectionCap& cap) const;
  bool meets_jump(const DirectionCap& cap) const;

  Layer layer_;
  SurfaceIndex index_;
  CapLimits wide_;                   // of caps that the index is not made for
  std::vector<RadiusRange> ranges_;  // of each face
  std::vector<Jump> jumps_;
  mutable std::vector<std::uint32_t> near_;  // scratch
};

}  // namespace impinge
