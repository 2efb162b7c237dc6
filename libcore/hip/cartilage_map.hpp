// SPDX-License-Identifier: GPL-3.0-or-later
// The thickness of the cartilage by direction. The thesis takes one thickness everywhere (4 mm, Section 3.4);
// real cartilage is thickest above and in front, and ends at the rim.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Thickness of both layers together (mm, 0 or more) in some directions from the centre (unit vectors). It
/// stays with the socket when the ball moves.
struct CartilageMap {
  std::vector<Vec3> directions;   // unit vectors from the centre of the socket
  std::vector<double> thickness;  // of each direction, mm
};

/// Thickness along a direction: the mean of the four nearest of the map, weighted by the inverse square of
/// their distance (Shepard 1968), so that the map's own values come back at its directions and no value lies
/// outside of theirs. The map must not be empty.
double thickness_at(const CartilageMap& map, const Vec3& direction);

/// Gaps as shares of the thickness at their places (centre frame, posed): 1 where the two layers of cartilage
/// begin to touch. Negative gaps, bone in bone, stay as they are; a gap over no cartilage is infinite.
std::vector<double> shares_of_cartilage(std::span<const double> gap, std::span<const Vec3> places,
                                        const CartilageMap& map);

}  // namespace impinge
