// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether the surfaces of ball and socket impinge, and not only their vertices: Theorem 6 (overlay).
//
// A surface is the set of points of its faces, without those that are edge-on at rest: their plane holds the
// centre of their own mesh, exactly, or they have no area (mesh/surface_vertices.hpp). Let X be the posed
// ball and Y the socket. A pose is impinged if, seen from the socket's or from the ball's centre,
//   (1)  some x in X lies on or beyond the socket: x = s y with y in Y, s >= 1, or
//   (2)  some y in Y lies on or within the ball: y = x / s with x in X, s >= 1; or y is the ball's centre
//        and the ball has a face.
// Surfaces with a common point are impinged. So is a ball that has slipped behind the rim of the socket; what
// (1) and (2) say about the intersection of the surfaces is in reference/meeting_surfaces.hpp.
// Directions in which one surface is missing never count; a surface includes its open edges.
//
// The two scans of the thesis sample (1) at vertices of the ball and (2) at vertices of the socket, and miss
// crossings of edges. (1) is decided in the socket frame, with vertices as to_socket() rounds them, (2) in
// the ball frame, with vertices as to_ball() rounds them; from there on all signs are exact.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gap/face_overlay.hpp"
#include "gap/surface.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// The deepest place of an impinged pose.
struct OverlayContact {
  double depth = 0.0;                        // mm, ball radius minus socket radius, in floating point
  OverlayKind kind = OverlayKind::crossing;  // corner, crossing of edges, or the centre
};

/// Two meshes, prepared for comparison in many poses.
class SurfaceOverlay {
 public:
  /// Takes the meshes in their centre frames, mm, and keeps them.
  SurfaceOverlay(TriangleMesh ball, TriangleMesh socket);

  /// Is the pose impinged? Exact: Theorem 6 (overlay).
  bool impinged(const Pose& pose) const;

  /// The deepest of all places where (1) or (2) holds; std::nullopt if and only if the pose is not impinged.
  std::optional<OverlayContact> deepest(const Pose& pose) const;

  const TriangleMesh& ball() const { return sides_[0]->mesh; }    // in its centre frame
  const TriangleMesh& socket() const { return sides_[1]->mesh; }  // in its centre frame
  /// The faces of a surface by direction.
  const NearFaces& faces(Surface of) const { return sides_[of == Surface::ball ? 0 : 1]->near; }

 private:
  /// A surface at rest.
  struct Side {
    explicit Side(TriangleMesh of);
    TriangleMesh mesh;
    std::vector<FaceCap> caps;  // of its faces
    NearFaces near;  // with a margin of about a face, so that most faces are looked up in one piece
  };
  template <class Visit>
  bool visit_pairs(Surface moved, const Pose& pose, const Visit& visit) const;
  template <class Visit>
  bool visit_both(const Pose& pose, const Visit& visit) const;

  std::array<std::unique_ptr<const Side>, 2> sides_;  // ball, socket
};

}  // namespace impinge
