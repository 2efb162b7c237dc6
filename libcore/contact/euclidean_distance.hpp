// SPDX-License-Identifier: GPL-3.0-or-later
// Euclidean distances from points to a surface, in double, with proven ends.
//
// A tree of boxes (Eigen's KdBVH) finds the face with the least distance. contact/part_distance.hpp has a
// distance from a face that is not above the true one but for 24 u D / kThin < 3e-13 D, D <= |x| + R, R the
// farthest corner: where a face is thin it takes the error off. The other end is the distance from a point of
// that face. The search skips boxes by distances that are off by a few u. Theorem 10 (distance).
#pragma once

#include <vector>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include "contact/turn_surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A Euclidean distance d, mm.
struct DistanceBracket {
  double lower_mm = 0.0;  // d is no less
  double upper_mm = 0.0;  // d is no more
};

/// Allowance for rounding at both ends, as a share of |x| + R.
inline constexpr double kDistanceAllowance = 1e-12;

class EuclideanDistance {
 public:
  /// mesh in mm; copied. std::invalid_argument for one without faces, and for lengths beyond those of
  /// mesh/lengths.hpp.
  explicit EuclideanDistance(const TriangleMesh& mesh);

  /// From x (mm, in the frame of the mesh) to the nearest point of any face.
  DistanceBracket at(const Vec3& x) const;

 private:
  std::vector<TurnFace> faces_;
  double farthest_ = 0.0;  // R, mm
  Eigen::KdBVH<double, 3, int> boxes_;
};

}  // namespace impinge
