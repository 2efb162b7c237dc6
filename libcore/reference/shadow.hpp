// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle for certified gaps: it finds which points of the ball lie behind the socket as the centre sees
// it, by clipping with CGAL's exact numbers and over all pairs of faces.
//
// The shadow of a face Y is {s y : y in Y, s >= 1}, bounded by its plane and by three planes through the
// centre; its pyramid is {y / s}. The library decides by signs of determinants at three kinds of places. Here
// the faces of the ball are cut along the four planes, and there is contact if something is left. The two
// share neither formula nor arithmetic.
#pragma once

#include <vector>

#include "mesh/triangle_distance.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Does x lie in the shadow of the face, its boundary included? False for a face whose plane holds the
/// centre. Exact: by intervals (CGAL::Interval_nt), or by rationals if they do not decide.
bool in_shadow(const Vec3& x, const Triangle& face);

/// Does x lie between the centre and the face, its boundary included? False for a face whose plane holds the
/// centre.
bool in_pyramid(const Vec3& x, const Triangle& face);

/// Does the ball's face, of any kind, have a point in the shadow of the socket's face? False if the plane of
/// the socket's face holds the centre.
bool meets_shadow(const Triangle& ball, const Triangle& socket);

/// Does the socket's face, of any kind, have a point in the pyramid of the ball's face? False if the plane of
/// the ball's face holds the centre.
bool meets_pyramid(const Triangle& socket, const Triangle& ball);

/// Does the plane of the face not hold the centre, exactly?
bool covers_directions(const Triangle& face);

/// A joint about the centre of one of its surfaces, with every vertex where a pose has put it (mm).
class ShadowReference {
 public:
  /// All faces must cover directions as seen from the centres of their own surfaces.
  ShadowReference(const TriangleMesh& ball, const TriangleMesh& socket);

  std::vector<bool> ball_vertices_impinged() const;    // in the shadow of some face of the socket
  std::vector<bool> socket_vertices_impinged() const;  // in the pyramid of some face of the ball
  bool ball_beyond_socket() const;  // about the socket's centre: some face of the ball meets a shadow
  bool socket_within_ball() const;  // about the ball's centre: some face of the socket meets a pyramid

 private:
  /// The directions and radii of a face, to leave out pairs that are far apart.
  struct Seen {
    Triangle corners;
    Vec3 axis;
    double angle;  // from the axis to the farthest corner
    double low;
    double high;
  };
  template <class Meets>
  bool any_pair(const Meets& meets) const;
  static bool share_directions(const Seen& a, const Seen& b);
  static Seen see(const Triangle& corners);

  std::vector<Vec3> ball_vertices_;
  std::vector<Vec3> socket_vertices_;
  std::vector<Seen> ball_;
  std::vector<Seen> socket_;
};

}  // namespace impinge
