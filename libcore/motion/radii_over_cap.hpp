// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre, and how far from it, the nearest layer of a surface is over a cap of directions:
// ends that close on the radius as the cap narrows.
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
#pragma once

#include <vector>

#include "contact/cap_limits.hpp"
#include "mesh/jump_edges.hpp"
#include "table/surface_index.hpp"

namespace impinge {

/// Of the nearest layer; numbers in double, rounded outwards.
class RadiiOverCap {
 public:
  /// mesh in the centre frame, mm. Faces whose plane holds the centre cover no direction and are left out.
  explicit RadiiOverCap(const TriangleMesh& mesh);

  /// No direction of the cap has a smaller radius, mm; infinite where the cap meets no face.
  double least(const DirectionCap& cap) const;
  /// Every direction of the cap is covered, at this radius or a smaller one, mm; infinite where that is not
  /// certain.
  double largest(const DirectionCap& cap) const;
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
  bool meets_jump(const DirectionCap& cap) const;

  SurfaceIndex index_;
  CapLimits wide_;             // of caps that the index is not made for
  std::vector<double> least_;  // of each face, mm
  std::vector<Jump> jumps_;
  mutable std::vector<std::uint32_t> near_;  // scratch
};

}  // namespace impinge
