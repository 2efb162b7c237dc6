// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/ball_socket_pair.hpp"
#include "phantoms/phantom.hpp"
#include "support/joined.hpp"

namespace impinge::test {

// A ball of 20 mm with a cone neck of half angle `neck` about +z, apex in the centre, out to 60 mm; a cup of
// 26 mm that opens towards +z with half angle `opening`. The neck may tilt by their difference whatever it
// turns about itself.
inline BallSocketPair cone_neck(double neck, double opening, std::size_t sides) {
  Revolution ball;
  ball.sides = sides;
  ball.rings = {{0.0, 60.0}, {0.5 * neck, 60.0}, {neck, 60.0}, {neck, 20.0}};
  for (double polar = neck; polar < kPi;) ball.rings.push_back({polar = std::min(kPi, polar + 0.15), 20.0});
  Revolution socket;
  socket.sides = sides;
  socket.axis = -Vec3::UnitZ();
  socket.rings = sphere_rings(26.0, kPi - opening, 0.1);
  return {revolve(ball), inside_out(revolve(socket))};
}

}  // namespace impinge::test
