// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of a body during an arc of a turn, and on which side of a cut they are (limits/clear_cuts.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "limits/clear_cuts.hpp"

namespace impinge {

/// From least to most.
struct CutRange {
  double low = 0.0;
  double high = 0.0;
};

/// Faces in the socket's frame, mm.
struct CutFaces {
  std::size_t each = 3;             // points of a face
  std::vector<Vec3> points;         // whose hull holds all of a face during the arc
  std::vector<CutRange> radius;     // of a face, mm, from the centre; empty if the body is shifted
  std::vector<std::uint32_t> face;  // its place in the mesh
  double off = 0.0;                 // mm, of all these points, with their rounding

  std::size_t size() const { return face.size(); }
  std::span<const Vec3> of(std::uint32_t k) const { return std::span(points).subspan(k * each, each); }
  /// Of a face along a direction, before `off`, mm times the direction's length.
  CutRange along(std::uint32_t k, const Vec3& direction) const;
};

/// From one half angle to another; one pose if they are the same.
struct CutArc {
  HalfAngle from{1, 0};
  HalfAngle to{1, 0};
  bool moves() const { return from != to; }
  double degrees() const { return degrees_of(to) - degrees_of(from); }
};

/// Those faces of the ball during the arc. Of one of 180 degrees and more they are of no use.
CutFaces ball_faces(const UncertainMesh& ball, std::span<const std::uint32_t> faces, const CutMotion& motion,
                    const CutArc& arc);
CutFaces socket_faces(const UncertainMesh& socket);

/// The direction, of length 1, across which two faces are farthest apart, and by how much: not above 0 where
/// they meet. The directions are those of the separating axis test, of the first three points of each.
struct CutGap {
  Vec3 direction;
  double mm;
};
CutGap widest_gap(std::span<const Vec3> a, std::span<const Vec3> b);

/// Do two triangles cross even if each of their points is off by that, mm?
bool certainly_cross(std::span<const Vec3> a, std::span<const Vec3> b, double off);

}  // namespace impinge
