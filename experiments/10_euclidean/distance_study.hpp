// SPDX-License-Identifier: GPL-3.0-or-later
// Compares radial gaps with Euclidean distances.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// A class of points by where their ray ends: on a face that it meets at less than `below_deg` to the normal,
// or at a rim, if a jump edge is nearer than that face.
struct DistanceZone {
  std::string_view name;  // in the results
  double below_deg;       // largest angle to the normal, degrees; infinite for the last zone
};
// From faces that look at the centre to those seen obliquely.
inline constexpr std::array<DistanceZone, 3> kFacingZones{
    {{"facing", 20.0}, {"oblique", 45.0}, {"steep", std::numeric_limits<double>::infinity()}}};
inline constexpr std::string_view kRimZone = "rim";  // zone of points that end at a rim

// The points of one zone.
struct DistanceShare {
  std::string_view zone;    // its name
  std::vector<double> gap;  // |gap| over the exact distance
};

// Sorts points (mm, in the frame of the mesh) into zones, in the order of kFacingZones and then the rim.
// Leaves out points in whose direction there is no surface, and points on the surface.
std::vector<DistanceShare> distance_shares(const TriangleMesh& mesh, std::span<const Vec3> points);

}  // namespace impinge::lab
