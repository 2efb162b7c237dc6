// SPDX-License-Identifier: GPL-3.0-or-later
// Where the faces of a body are during an arc of a turn (limits/clear_cuts.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "limits/clear_cuts.hpp"

namespace impinge {

/// The least and the largest value of something, mm.
struct CutRange {
  double low = 0.0;
  double high = 0.0;
};

/// Faces in the socket's frame, mm.
struct CutFaces {
  std::size_t each = 3;             // points of a face: 3 at rest, 9 during an arc
  std::vector<Vec3> points;         // the hull of a face's points holds it during all of the arc
  std::vector<CutRange> radius;     // distances of each face from the centre; empty if the body is shifted
  std::vector<std::uint32_t> face;  // index of each face in the mesh
  double off = 0.0;                 // mm: no point is farther from its true place, rounding included

  std::size_t size() const { return face.size(); }
  std::span<const Vec3> of(std::uint32_t k) const { return std::span(points).subspan(k * each, each); }
  /// The range of direction . x over face k, without `off`.
  CutRange along(std::uint32_t k, const Vec3& direction) const;
};

/// The arc from one half angle to another; a single pose if they are the same.
struct CutArc {
  HalfAngle from{1, 0};
  HalfAngle to{1, 0};
  bool moves() const { return from != to; }
  double degrees() const { return degrees_of(to) - degrees_of(from); }
};

/// The given faces of the ball during an arc of less than 180 degrees.
CutFaces ball_faces(const UncertainMesh& ball, std::span<const std::uint32_t> faces, const CutMotion& motion,
                    const CutArc& arc);
CutFaces socket_faces(const UncertainMesh& socket);

/// The unit direction along which two triangles, the first three points of each span, are farthest apart, and
/// by how much: not above 0 where they meet. Directions are those of the separating axis test.
struct CutGap {
  Vec3 direction;
  double mm;
};
CutGap widest_gap(std::span<const Vec3> a, std::span<const Vec3> b);

/// Do two triangles cross, even if each of their points is wrong by up to `off` mm? Yes is certain.
bool certainly_cross(std::span<const Vec3> a, std::span<const Vec3> b, double off);

}  // namespace impinge
