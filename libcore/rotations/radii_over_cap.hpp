// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of the radius of a surface's nearest or farthest layer over a cap of directions; they close on the
// radius as the cap narrows. After Theorem 17 (resection).
#pragma once

#include <vector>

#include "contact/cap_limits.hpp"
#include "mesh/jump_edges.hpp"
#include "sphere/infinity.hpp"
#include "table/surface_index.hpp"

namespace impinge {

/// Caps up to this radius, radians, are answered face by face; wider ones by CapLimits.
inline constexpr double kIndexReach = 0.1;
/// Answers are rounded outwards by this share of a radius.
inline constexpr double kOutwards = 1e-9;

/// Bounds of one layer, rounded outwards. A direction without a surface counts as infinite for the nearest
/// layer, as -infinity for the farthest. The bound that needs the surface to go on over the cap is infinite
/// where a jump edge (mesh/jump_edges.hpp) may meet the cap.
class RadiiOverCap {
 public:
  /// mesh in the centre frame, mm. Edge-on faces are left out.
  RadiiOverCap(const TriangleMesh& mesh, Layer layer);

  /// A lower bound of the radius over the cap, mm.
  double least(const DirectionCap& cap) const { return nearest() ? of_faces(cap) : of_sheet(cap); }
  /// An upper bound of the radius over the cap, mm.
  double largest(const DirectionCap& cap) const { return nearest() ? of_sheet(cap) : of_faces(cap); }
  /// The radius along unit u, mm; NaN where nothing is met.
  double radius(const Vec3& u) const { return index_.radius(u); }

 private:
  /// A jump edge, as the centre sees it.
  struct Jump {
    Vec3 from;     // unit vector to one end
    Vec3 to;       // unit vector to the other end
    Vec3 middle;   // unit vector between them
    double angle;  // radians from the middle to the ends
  };
  bool nearest() const { return layer_ == Layer::nearest; }
  double none() const { return nearest() ? kInfinity : -kInfinity; }
  double of_faces(const DirectionCap& cap) const;
  double of_sheet(const DirectionCap& cap) const;
  bool meets_jump(const DirectionCap& cap) const;

  Layer layer_;
  SurfaceIndex index_;
  CapLimits wide_;                   // for caps wider than kIndexReach
  std::vector<RadiusRange> ranges_;  // of each face, mm
  std::vector<Jump> jumps_;
  mutable std::vector<std::uint32_t> near_;  // scratch
};

}  // namespace impinge
