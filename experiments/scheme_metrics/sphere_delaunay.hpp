// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps between directions on the sphere, and the area that each one represents, from their Delaunay
// triangulation. Angles in radians, areas in steradians. The direction farthest from all others is the centre
// of a triangle's circle; centres are also the corners of the Voronoi cells. They are computed in double:
// with spacing h and least distance e between directions they are off by about 1e-16 / (e h), which is 1e-11
// for RSID at 1 degree.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

// Entries with the same direction, such as a pole row or entries on the edges of a cube map, are joined.

/// Entries no farther apart count as one direction; far above rounding, far below any spacing. Radians.
inline constexpr double kCoincident = 1e-9;

struct DistinctDirections {
  std::vector<Vec3> direction;        // the direction of the first entry of each
  std::vector<std::size_t> of_entry;  // index in `direction` of each entry
  std::vector<std::size_t> entries;   // number of entries of each direction
};

/// Takes unit vectors in the order of the entries; returns directions in the order of their first entry.
/// Throws std::invalid_argument if one is not finite or is zero.
DistinctDirections distinct_directions(std::span<const Vec3> entries);

// The Delaunay triangulation of directions on the sphere, by CGAL with exact predicates. No header of
// CGAL is needed to use it.

/// Indices of three directions, counter-clockwise as seen from outside.
using SphereTriangle = std::array<std::size_t, 3>;

/// The triangles whose circles hold no other direction inside: 2 n - 4 for n directions. Directions are taken
/// as rays, so rounding of their lengths does not matter. If four or more lie on one circle, any of their
/// triangulations is right, and one is chosen. Throws std::invalid_argument for fewer than four directions,
/// for directions in one hemisphere, for two equal ones, and for one that is zero or not finite.
std::vector<SphereTriangle> delaunay_triangles(std::span<const Vec3> directions);

/// A circle with no direction inside.
struct EmptyCircle {
  Vec3 centre = Vec3::UnitZ();  // unit vector
  double radius = 0.0;          // angle from the centre to the circle, radians
};

/// The triangles between directions, and the gaps inside them.
struct SphereDelaunay {
  DistinctDirections distinct;            // corners of the triangles
  std::vector<SphereTriangle> triangles;  // indices of distinct directions
  std::vector<EmptyCircle> gaps;          // circle of each triangle
};

/// Takes unit vectors, of which some may be equal. Throws std::invalid_argument for fewer than four different
/// ones, and for directions in one hemisphere.
SphereDelaunay sphere_delaunay(std::span<const Vec3> entries);

/// The widest gap whose centre has |z| <= z_max. Its radius is the covering radius, or the covering radius
/// away from the poles; 0 if there is no such centre.
EmptyCircle widest_gap(const SphereDelaunay& delaunay, double z_max = 1.0);

/// Voronoi area of each distinct direction, steradians; they sum to 4 pi.
std::vector<double> voronoi_areas(const SphereDelaunay& delaunay);

/// Area of each entry, steradians: entries of one direction share its Voronoi area evenly.
std::vector<double> entry_areas(const SphereDelaunay& delaunay);

}  // namespace impinge
