// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices of a generated hip, ring by ring, for mesh/loft.hpp.
#pragma once

#include <vector>

#include "hip/hip_surface.hpp"

namespace impinge {

inline constexpr double kBandHeight = 0.8660254037844386;  // of equilateral triangles with edges of 1

using PointRings = std::vector<std::vector<Vec3>>;  // points of each ring, mm

/// Rings of the femur about the neck axis: from the pole of the head opposite the neck, round the bend and
/// down the shaft to the middle of its end. Edges are about `spacing` mm long, shorter where head and neck
/// meet, longer along the shaft.
PointRings femur_rings(const HipSurface& hip, double spacing);

/// Rings of the acetabulum, from the pole of the socket to its rim; with a wall, back on its outer side.
PointRings acetabulum_rings(const HipSurface& hip, double spacing);

}  // namespace impinge
