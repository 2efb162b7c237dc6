// SPDX-License-Identifier: GPL-3.0-or-later
// How far radial gaps are above Euclidean distances.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// Where the ray of a point ends: on a face that it meets at an angle of less than `below_deg` to the normal,
// or, where a jump edge is nearer than that face, at a rim.
struct DistanceZone {
  std::string_view name;  // in the results
  double below_deg;       // largest angle to the normal, degrees; infinite for the last zone
};
// From faces that look at the centre to those seen obliquely.
inline constexpr std::array<DistanceZone, 3> kFacingZones{
    {{"facing", 20.0}, {"oblique", 45.0}, {"steep", std::numeric_limits<double>::infinity()}}};
inline constexpr std::string_view kRimZone = "rim";  // the zone of points that end at a rim

// The points of one zone.
struct DistanceShare {
  std::string_view zone;    // its name
  std::vector<double> gap;  // |gap| over the exact distance
};

// Points (mm, in the frame of the mesh) by zones, in the order of kFacingZones and the rim. Points along
// whose direction there is no surface, or that lie on it, are left out.
std::vector<DistanceShare> distance_shares(const TriangleMesh& mesh, std::span<const Vec3> points);

}  // namespace impinge::lab
