// SPDX-License-Identifier: GPL-3.0-or-later
// Which radii along the rays of a cap of directions lie in bone, the inside of a closed mesh.
//
// Each face that may meet the cap has a range of radii there (table/surface_plane.hpp). Between those ranges
// no ray of the cap crosses the surface, so that all of them are in bone or none is. Which, is found by
// counting how often one ray has gone in and out, along a direction of the cap that passes no edge within
// rounding. All rays start at the centre, which is outside. Where there is no such direction nothing is
// certain.
#pragma once

#include <vector>

#include "contact/cap_limits.hpp"
#include "rotations/ray_spans.hpp"
#include "table/surface_index.hpp"

namespace impinge {

/// Numbers in double, rounded outwards.
class BoneOverCap {
 public:
  /// mesh in the centre frame, mm. std::runtime_error, one line, unless it is closed and of one orientation.
  explicit BoneOverCap(const TriangleMesh& mesh);

  /// Radii in bone, mm.
  SpansOverCap over(const DirectionCap& cap) const;

 private:
  bool crossings_along(const Vec3& u) const;
  bool find_crossings(const DirectionCap& cap) const;

  SurfaceIndex index_;
  CapLimits nearest_;  // of caps that the index is not made for
  CapLimits farthest_;
  std::vector<double> least_;  // of each face, mm
  /// A face that may meet the cap.
  struct Crossed {
    RadiusRange range;
    int winding = 0;  // of the ray that is counted along: 1 goes in, or out where the mesh is inside out
  };
  mutable std::vector<std::uint32_t> near_;  // scratch
  mutable std::vector<Crossed> crossed_;     // the same
};

}  // namespace impinge
