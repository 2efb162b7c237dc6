// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between directions on the sphere and the area that each stands for, from their Delaunay triangulation.
// Angles in radians, areas in steradians.
//
// The direction farthest from all others is the centre of a triangle's circle, and where three or more such
// circles meet the nearest direction changes: centres are the corners of the Voronoi cells. Centres are
// computed in double. With spacing h and least distance e between directions they are off by about 1e-16 / (e
// h): 1e-11 for RSID at 1 degree.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

// Entries that share one direction, as those of a pole row or on the edges of a cube map do, taken together.

/// Entries no farther apart count as one direction: far above rounding, far below any spacing. Radians.
inline constexpr double kCoincident = 1e-9;

struct DistinctDirections {
  std::vector<Vec3> direction;        // that of the first entry of each
  std::vector<std::size_t> of_entry;  // place of each entry in `direction`
  std::vector<std::size_t> entries;   // number of entries of each direction
};

/// Unit vectors in, in the order of the entries; directions come out in the order of their first entry.
/// std::invalid_argument where one is not finite or is zero.
DistinctDirections distinct_directions(std::span<const Vec3> entries);

// The Delaunay triangulation of directions on the sphere, by CGAL with exact predicates; no header of CGAL is
// needed to use it.

/// Places of three directions, counter-clockwise as seen from outside.
using SphereTriangle = std::array<std::size_t, 3>;

/// Triangles whose circles hold no other direction inside: 2 n - 4 for n directions, which are taken as rays,
/// so that the rounding of their lengths does not count. Where four or more lie on one circle any of their
/// triangulations is right, and one is chosen. Throws std::invalid_argument for fewer than four directions,
/// for directions that all lie in one hemisphere, two that are the same, and one that is zero or not finite.
std::vector<SphereTriangle> delaunay_triangles(std::span<const Vec3> directions);

/// A circle with no direction inside.
struct EmptyCircle {
  Vec3 centre = Vec3::UnitZ();  // unit vector
  double radius = 0.0;          // angle from the centre to the circle, radians
};

/// The triangles between directions, and the gaps in them.
struct SphereDelaunay {
  DistinctDirections distinct;            // whose corners they have
  std::vector<SphereTriangle> triangles;  // of distinct directions
  std::vector<EmptyCircle> gaps;          // circle of each triangle
};

/// Unit vectors in, some of which may be the same. Throws std::invalid_argument for fewer than four that
/// differ and for directions that all lie in one hemisphere.
SphereDelaunay sphere_delaunay(std::span<const Vec3> entries);

/// The widest gap whose centre has |z| <= z_max: its radius is the covering radius, or that away from the
/// poles. Radius 0 where there is no such centre.
EmptyCircle widest_gap(const SphereDelaunay& delaunay, double z_max = 1.0);

/// Voronoi area of each distinct direction, steradians; they sum to 4 pi.
std::vector<double> voronoi_areas(const SphereDelaunay& delaunay);

/// Area of each entry, steradians: entries of one direction share its Voronoi area evenly.
std::vector<double> entry_areas(const SphereDelaunay& delaunay);

}  // namespace impinge
