// SPDX-License-Identifier: GPL-3.0-or-later
// What a place where two bones meet is called. R is the radius of the sphere that fits the head, S that of
// the sphere that fits the inside of the socket, c their centres, p the rim (rim_profile.hpp). x is
//   trochanter or shaft   |x - c| > 1.5 R: beyond the surface of the joint of a whole bone (whole_bone.hpp)
//   neck                  else |x - c| > 1.02 R, less than 90 degrees from the neck axis: the surface has
//   left
//                         the head, by the tolerance of the alpha angle (hip_surface.hpp). So has a cam
//   head                  else, bumps on its far side included
// and y is
//   rim                   |y - p| <= 0.2 S for some p: 5 mm on a socket of 25 mm
//   inside of the socket  nearer to the pole than the nearest p, and |y - c| <= 1.25 S, which holds the fossa
//   bone beyond the rim   else
// It is the same of a whole bone, of one that is cut, and of one that is not named so, such as a cup. Bone
// that is given beside them has its own name (mesh/mesh_parts.hpp).
// The rim alone: faces of a socket's bone with a corner that is 0.1 S or less from the rim, 2.5 mm on a
// socket of 25, and of a ball's bone with a corner off the head, which is trochanter or shaft, or on the side
// of the neck axis farther off the head's sphere than any place of the head on the other side, within 0.005 R
// and 0.04 R (our choices): as far as heads of real scans are. So head and floor of the socket, which bear on
// each other, are not in it.
#pragma once

#include <optional>
#include <string>

#include "hip/rim_profile.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// What places are told by, in the frame of the meshes.
struct JointPlaces {
  std::optional<SphereFit> head;    // none where no sphere fits
  Vec3 neck = Vec3::Zero();         // unit vector along its axis; 0 where the ball ends before its neck
  std::optional<SphereFit> socket;  // the same; none without a head
  std::optional<RimProfile> rim;    // about the centre of `socket`; none where there is no rim
};

/// Of the main surfaces of a joint, mm, in one frame.
JointPlaces joint_places(const BallSocketPair& main);

/// As above, x in the frame of the ball's mesh at rest; "ball" without a head.
std::string place_on_ball(const JointPlaces& places, const Vec3& x);
/// As above; "socket" without a rim.
std::string place_on_socket(const JointPlaces& places, const Vec3& y);

/// Leaves the faces that the rim alone is of, as above; vertices keep their places. `origin` is that of the
/// mesh, in the frame of the places. std::invalid_argument, one line, where there are none.
void leave_rim(const JointPlaces& places, const Vec3& origin, TriangleMesh& socket);
void leave_off_head(const JointPlaces& places, const Vec3& origin, TriangleMesh& ball);

/// How deep the rim is within the head's sphere, mm; none where it is clear of it. There it meets a neck
/// late, and a rim without thickness does not meet it.
std::optional<double> rim_in_head(const JointPlaces& places);

/// What meets what: "rim and neck", "head within the socket", "AIIS and greater trochanter". Both names are
/// those of places, or of parts.
std::string meeting_words(const std::string& ball, const std::string& socket);

}  // namespace impinge
