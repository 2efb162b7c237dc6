// SPDX-License-Identifier: GPL-3.0-or-later
// Euclidean distances from points to a surface, in double, between proven ends: Theorem 10 (distance).
//
// A search in a tree of boxes (Eigen's KdBVH) finds the least of the distances of contact/part_distance.hpp.
// It is above the true one by at most 24 u D / kThin < 3e-13 D, where D is the distance of x from a corner,
// D <= |x| + R, R that of the farthest corner from the origin. The upper end is the least distance of x from
// points of the faces looked at. The search skips boxes by distances that are off by a few u.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include "contact/turn_surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A Euclidean distance d, mm.
struct DistanceBracket {
  double lower_mm = 0.0;  // d is not below this
  double upper_mm = 0.0;  // d is not above this
};

/// The allowance for rounding at both ends, as a share of |x| + R.
inline constexpr double kDistanceAllowance = 1e-12;

class EuclideanDistance {
 public:
  /// Copies the mesh, mm. Throws std::invalid_argument for a mesh without faces, and for lengths outside of
  /// the range of mesh/lengths.hpp.
  explicit EuclideanDistance(const TriangleMesh& mesh);

  /// The distance from each point (mm, in the frame of the mesh) to the nearest point of any face. Quick
  /// where points are near those before them, as the search begins with the face that these found.
  std::vector<DistanceBracket> at(std::span<const Vec3> points) const;

 private:
  std::vector<TurnFace> faces_;
  double farthest_ = 0.0;  // R, mm
  Eigen::KdBVH<double, 3, int> boxes_;
};

}  // namespace impinge
