// SPDX-License-Identifier: GPL-3.0-or-later
// Which radii along the rays of a cap of directions lie in bone, the inside of a closed mesh? Rays start at
// the centre, which must be outside of the bone. After Theorem 18 (sweep).
#pragma once

#include <vector>

#include "contact/cap_limits.hpp"
#include "rotations/ray_spans.hpp"
#include "table/surface_index.hpp"

namespace impinge {

/// Numbers in double, rounded outwards.
class BoneOverCap {
 public:
  /// mesh in the centre frame, mm. Throws std::runtime_error, one line, unless it is_bone_beside_centre()
  /// (rotations/bone_along_rays.hpp).
  explicit BoneOverCap(const TriangleMesh& mesh);

  /// Radii in bone over the cap, mm: certain along every ray, possible along any.
  SpansOverCap over(const DirectionCap& cap) const;

 private:
  bool crossings_along(const Vec3& u) const;
  bool find_crossings(const DirectionCap& cap) const;

  SurfaceIndex index_;
  CapLimits nearest_;  // these two are for caps wider than kIndexReach
  CapLimits farthest_;
  std::vector<double> least_;  // least radius of each face, mm
  /// A face that may meet the cap.
  struct Crossed {
    RadiusRange range;
    int winding = 0;  // 1 where the counted ray goes into bone, -1 where it leaves; opposite if inside out
  };
  mutable std::vector<std::uint32_t> near_;  // scratch
  mutable std::vector<Crossed> crossed_;     // scratch
};

}  // namespace impinge
