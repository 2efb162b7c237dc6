// SPDX-License-Identifier: GPL-3.0-or-later
// Do the surfaces of ball and socket impinge, and not only their vertices?
//
// What is decided. A surface is the set of points of its faces, but for those that are edge-on at rest: whose
// plane holds the centre of their own mesh, exactly, or that have no area (mesh/surface_vertices.hpp). These
// cover no direction, and take no part in any pose and either frame. Let X be the posed ball and Y the
// socket. Seen from the socket's centre the ball impinges if
//   (1)  some x in X lies on or beyond the socket: x = s y with y in Y, s >= 1,
// and seen from the ball's centre if
//   (2)  some y in Y lies on or within the ball: y = x / s with x in X, s >= 1; or y is the ball's centre,
//        to which x / s comes as s grows, and the ball has a face.
// A pose is impinged if (1) or (2) holds. That is what the two scans of the thesis sample at vertices, (1) at
// those of the ball and (2) at those of the socket, and
//   * it is complete: surfaces with a common point satisfy both, s = 1;
//   * without a translation (1) and (2) are one statement, B(u) >= S(u) in some direction u of both;
//   * with one they differ where rays do. For a closed, star-shaped ball (2) implies (1): a ray from the
//     centre of the socket that enters it leaves it again, farther out. Neither asks for a common point: a
//     ball that has slipped behind the rim of the socket is beyond it, and impinged. What they have to do
//     with the intersection of the surfaces is said and proven in reference/meeting_surfaces.hpp;
//   * directions in which one surface is missing never count: an open rim ends the statement with the
//     surface, its edges and corners included;
//   * which faces count depends on the meshes alone, and all else is a set of points that a pose moves: a
//   face
//     that a pose makes edge-on about the other centre, by rounding or in truth, is in it as it is in any
//     other pose. A closed surface that is only turned loses nothing with its edge-on faces: their sides are
//     sides of others, and along a ray of its plane a face is nearest and farthest on its sides. Shifted, it
//     is not seen from aside where such a face was;
//   * at a centre: a point of the ball is never beyond the socket, one of the socket is within any ball.
// (1) is decided in the socket frame, with the vertices of the ball as to_socket() rounds them, (2) in the
// ball frame, with those of the socket as to_ball() rounds them; from there on all signs are exact. By
// gap/face_overlay.hpp it is enough to look, for each pair of faces with a common direction, at the
// corners of each over the other and at the crossings of their edges, which no scan of vertices sees.
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

/// Two meshes made ready to be compared in many poses.
class SurfaceOverlay {
 public:
  /// Meshes in their centre frames, mm; they are kept.
  SurfaceOverlay(TriangleMesh ball, TriangleMesh socket);

  /// Is the pose impinged? Exact: Theorem 6 (overlay).
  bool impinged(const Pose& pose) const;

  /// The deepest of all places where (1) or (2) holds; none if and only if the pose is not impinged.
  std::optional<OverlayContact> deepest(const Pose& pose) const;

  const TriangleMesh& ball() const { return sides_[0]->mesh; }    // in its centre frame
  const TriangleMesh& socket() const { return sides_[1]->mesh; }  // in its centre frame
  /// The faces of that surface by direction.
  const NearFaces& faces(Surface of) const { return sides_[of == Surface::ball ? 0 : 1]->near; }

 private:
  /// A surface at rest.
  struct Side {
    explicit Side(TriangleMesh of);
    TriangleMesh mesh;
    std::vector<FaceCap> caps;  // of its faces
    NearFaces near;  // with a margin of about a face, for most of them to be looked up in one piece
  };
  template <class Visit>
  bool visit_pairs(Surface moved, const Pose& pose, const Visit& visit) const;
  template <class Visit>
  bool visit_both(const Pose& pose, const Visit& visit) const;

  std::array<std::unique_ptr<const Side>, 2> sides_;  // ball, socket
};

}  // namespace impinge
