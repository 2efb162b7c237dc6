// SPDX-License-Identifier: GPL-3.0-or-later
// The thickness of the cartilage by direction. The thesis takes one thickness everywhere (4 mm, Section 3.4);
// real cartilage is thickest above and in front, and ends at the rim.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Thickness of both layers together (mm, 0 or more) at sampled directions from the centre. The map stays
/// with the socket when the ball moves.
struct CartilageMap {
  std::vector<Vec3> directions;   // unit vectors from the centre of the socket
  std::vector<double> thickness;  // of each direction, mm
};

/// Thickness (mm) along a direction of any length above 0: the mean over the map's four nearest directions,
/// weighted by the inverse square of their distance (Shepard 1968). It reproduces the map's values at its own
/// directions and never leaves their range. The map must not be empty.
double thickness_at(const CartilageMap& map, const Vec3& direction);

/// Each gap (mm) divided by the thickness at its place (centre frame, posed); the result is 1 where the two
/// layers of cartilage begin to touch. Gaps of 0 or less, bone on bone, stay in mm. A gap over no cartilage
/// becomes infinite; NaN stays NaN.
std::vector<double> shares_of_cartilage(std::span<const double> gap, std::span<const Vec3> places,
                                        const CartilageMap& map);

}  // namespace impinge
