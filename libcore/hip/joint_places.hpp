// SPDX-License-Identifier: GPL-3.0-or-later
// Names the place where two bones meet, such as "rim" or "neck", and picks the faces of the rim alone. R is
// the radius of the sphere that fits the head, S that of the sphere that fits the inside of the socket, c the
// centre of either, p a point of the rim (rim_profile.hpp). The names are the same for a whole bone, a cut
// one and an implant such as a cup. Bone that is given beside them has its own name (mesh/mesh_parts.hpp).
#pragma once

#include <optional>
#include <string>

#include "hip/rim_profile.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// What is needed to name places, in the frame of the meshes.
struct JointPlaces {
  std::optional<SphereFit> head;    // none where no sphere fits
  Vec3 neck = Vec3::Zero();         // unit vector along its axis; 0 where the ball ends before its neck
  std::optional<SphereFit> socket;  // none without a head
  std::optional<RimProfile> rim;    // about the centre of `socket`; none where there is no rim
};

/// The places of a joint whose main surfaces are in one frame, mm.
JointPlaces joint_places(const BallSocketPair& main);

/// Name of the place x, in the frame of the ball's mesh at rest; "ball" without a head. It is the first of
///   trochanter or shaft   |x - c| > 1.5 R, beyond what a whole bone gives to the joint (whole_bone.hpp)
///   neck                  |x - c| > 1.02 R, less than 90 degrees from the neck axis: the surface has left
///                         the head by the tolerance of the alpha angle (hip_surface.hpp). A cam is neck, too
///   head                  all else, which includes bumps on the far side
std::string place_on_ball(const JointPlaces& places, const Vec3& x);
/// Name of the place y; "socket" without a rim. It is the first of
///   rim                   |y - p| <= 0.2 S for some p: 5 mm on a socket of 25 mm
///   inside of the socket  nearer to the pole than the nearest p, and |y - c| <= 1.25 S, so with the fossa
///   bone beyond the rim   all else
std::string place_on_socket(const JointPlaces& places, const Vec3& y);

/// Leaves only the faces of "the rim alone", without head and floor of the socket, which bear on each other.
/// For a socket these are faces with a corner at most 0.1 S from the rim. For a ball they are faces with a
/// corner beyond 1.5 R, or on the side of the neck and farther off the head's sphere than any place on the
/// other side. This distance is kept within 0.005 R and 0.04 R (our choice), which is as far as the heads of
/// real scans are off. Vertices keep their indices. `origin` is the origin of the mesh in the frame of the
/// places. Throws std::invalid_argument, one line, if no face is left.
void leave_rim(const JointPlaces& places, const Vec3& origin, TriangleMesh& socket);
void leave_off_head(const JointPlaces& places, const Vec3& origin, TriangleMesh& ball);

/// How deep the rim lies within the head's sphere, mm; none where it is clear of the sphere. A rim within it
/// meets a neck late, and a rim without thickness does not meet it at all.
std::optional<double> rim_in_head(const JointPlaces& places);

/// Names what meets: "rim and neck", "head within the socket", "AIIS and greater trochanter". Both arguments
/// are names of places or of parts.
std::string meeting_words(const std::string& ball, const std::string& socket);

}  // namespace impinge
