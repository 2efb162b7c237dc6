// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between directions on the sphere and the area that each stands for, from their Delaunay triangulation.
// Angles in radians, areas in steradians.
//
// The direction farthest from all others is the centre of a triangle's circle, and where three or more such
// circles meet the nearest direction changes: centres are the corners of the Voronoi cells. Centres are
// computed in double. With spacing h and least distance e between directions they are off by about 1e-16 / (e
// h): 1e-11 for RSID at 1 degree.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scheme_metrics/distinct_directions.hpp"
#include "scheme_metrics/sphere_triangles.hpp"
#include "sphere/direction.hpp"

namespace impinge {

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
