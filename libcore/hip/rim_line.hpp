// SPDX-License-Identifier: GPL-3.0-or-later
// The rim of a socket as a closed line, to draw its clock on.
#pragma once

#include <cstddef>
#include <vector>

#include "hip/clock.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A point of the rim.
struct RimPoint {
  double hours = 0.0;         // on the dial
  Vec3 place = Vec3::Zero();  // frame of the socket, mm
};

/// Cuts the dial into `sectors` of equal size. Takes from each the vertex at the largest angle from the pole
/// of the socket, as seen from the centre; vertices without faces do not count. Clockwise from 12 o'clock; a
/// sector without vertices has no point. Socket and dial are in the joint frame, with the centre as origin.
std::vector<RimPoint> rim_line(const TriangleMesh& socket, const ClockFace& dial, std::size_t sectors);

}  // namespace impinge
