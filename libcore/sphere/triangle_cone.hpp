// SPDX-License-Identifier: GPL-3.0-or-later
// A face as the centre sees it: the cone of directions that meet it, and the radius along each.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "sphere/face_plane.hpp"
#include "sphere/orientation.hpp"
#include "sphere/plane_radius.hpp"

namespace impinge {

/// Corners a, b, c in the centre frame (mm). The face may be front-facing (normal away from the centre, a
/// ball) or back-facing (normal towards it, a socket); both are met alike.
class TriangleCone {
 public:
  /// The cone of the face a, b, c, in mm.
  TriangleCone(const Vec3& a, const Vec3& b, const Vec3& c);

  /// Does the plane of the face pass through the centre, exactly? Then no direction meets its inside in one
  /// point.
  bool edge_on() const { return side_ == 0; }

  /// +1 front-facing, -1 back-facing, 0 edge-on.
  int side() const { return side_; }

  const std::array<Vec3, 3>& corners() const& { return corner_; }  // as given, mm
  const std::array<Vec3, 3>& corners() const&& = delete;           // they would be gone before they are read

  /// Does the ray along unit u meet the face, boundary included? Exact: at least one of the faces round an
  /// edge or vertex answers yes.
  bool contains(const Vec3& u) const {
    bool certain = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double distance = edge_plane_[k].dot(u);
      if (distance < -doubt_[k]) return false;
      certain = certain && distance > doubt_[k];
    }
    return certain || place_in_cone(corner_, side_, u) >= 0;
  }

  /// Least of the three edge plane tests for u = (x, y, z): above `doubt()` the cone contains u, below
  /// -doubt() it does not, and in between contains() decides. For loops over many directions.
  double least_edge_distance(double x, double y, double z) const {
    const double e0 = edge_plane_[0].x() * x + edge_plane_[0].y() * y + edge_plane_[0].z() * z;
    const double e1 = edge_plane_[1].x() * x + edge_plane_[1].y() * y + edge_plane_[1].z() * z;
    const double e2 = edge_plane_[2].x() * x + edge_plane_[2].y() * y + edge_plane_[2].z() * z;
    const double least = e0 < e1 ? e0 : e1;
    return least < e2 ? least : e2;
  }
  double doubt() const { return std::max({doubt_[0], doubt_[1], doubt_[2]}); }  // see least_edge_distance()

  /// The plane of the face; its offset is above 0 unless the face is seen edge-on, or nearly so.
  const FacePlane& plane() const& { return plane_; }
  const FacePlane& plane() const&& = delete;

  /// Distance of the centre from the plane of the face, mm.
  double plane_distance() const { return plane_.offset / plane_.normal.norm(); }

  /// The radius r = n.v0 / (n.u) along a unit u that the cone contains, mm. It is never above the radius of
  /// the farthest corner, which matters only if u grazes the face and n.u is rounding noise; for a face that
  /// is seen edge-on but for rounding it is the radius of the nearest corner.
  double radius(const Vec3& u) const {
    if (grazing_) return smallest_radius_;
    return plane_radius<double>(plane_.normal, plane_.offset, largest_radius_, u);
  }

  /// Largest tan psi over the face, psi the angle between direction and normal. The directions with psi below
  /// a limit form a convex cone, so that the largest is at a corner. This is |grad r| / r on the unit sphere.
  double largest_slope() const {
    if (grazing_) return std::numeric_limits<double>::infinity();
    double slope = 0.0;
    for (const Vec3& v : corner_)
      slope = std::max(slope, plane_.normal.cross(v).norm() / plane_.normal.dot(v));
    return slope;
  }

 private:
  std::array<Vec3, 3> corner_;
  int side_;
  FacePlane plane_;
  double largest_radius_;
  double smallest_radius_;
  bool grazing_;  // its plane is so near to the centre that no digit of n.u or of n.v0 is certain
  std::array<Vec3, 3> edge_plane_;
  std::array<double, 3> doubt_{};
};

}  // namespace impinge
