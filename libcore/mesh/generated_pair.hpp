// SPDX-License-Identifier: GPL-3.0-or-later
// A generated ball-and-socket joint: a spherical head with a smooth cam bump in a spherical cup with a rim,
// both about the origin (the centre of rotation), the socket's pole on +z. Its exact gap is known in every
// pose.
#pragma once

#include <cstddef>

#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// The defaults have a joint space of 4 mm and a cam of 3 mm: no rotation about the centre brings the ball
/// nearer to the socket than 1 mm. Lengths in mm, angles in degrees.
struct PairShape {
  double head_radius = 22.0;         // of the ball, without its bump
  double socket_radius = 26.0;       // of the inside of the socket; above head_radius
  double half_opening_deg = 87.0;    // from the socket's pole to its rim
  double cam_height = 3.0;           // of the bump above the head
  double cam_half_width_deg = 30.0;  // from the top of the bump to its foot
  double cam_polar_deg = 130.0;  // of the top of the bump, from +z; its foot is 13 degrees outside of the rim
  double cam_azimuth_deg = 0.0;  // of the top of the bump, from +x towards +y
};

/// A cam of 5 mm, higher than the joint space. Unrotated, the pair is free: no part of the bump faces the
/// socket. A rotation about +y by -34.1 degrees or beyond moves the cam towards the pole, brings the part of
/// the bump above 4 mm (8.9 degrees about its top) under the socket, and impinges by up to 1 mm.
PairShape impinging_cam();

/// Direction of the top of the bump.
Vec3 cam_direction(const PairShape& shape);

/// Radius (mm) of the smooth ball along a direction. Within the bump it is head + height * cos^2(pi/2 * angle
/// / half width), which joins the head with a continuous slope.
double ball_radius(const Vec3& direction, const PairShape& shape = {});

/// The pair as meshes with exactly faces_per_model faces each. Throws std::invalid_argument unless that is
/// even and at least 8. Vertices lie on the smooth surfaces; the ball has a vertex on both poles, the socket
/// one on +z.
BallSocketPair make_ball_socket_pair(std::size_t faces_per_model, const PairShape& shape = {});

}  // namespace impinge
