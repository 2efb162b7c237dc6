// SPDX-License-Identifier: GPL-3.0-or-later
// Method distance_grid: distances from the surface on the nodes of a regular Cartesian grid, interpolated
// trilinearly. The thesis (Section 3.6.2) argues that its memory grows with the cube of the resolution, where
// that of a table grows with the square.
//
// Bound. A distance changes by no more than the way, so that an answer, a mean of the eight nodes with
// weights w, errs by at most sum w_i |x - x_i| <= sqrt(sum w_i |x - x_i|^2) = h sqrt(sum_k t_k (1 - t_k)) <=
// h sqrt(3) / 2, h the spacing and t the place in the cell. Floats add 2^-24 of the largest distance.
#pragma once

#include <cstddef>
#include <memory>

#include "methods/grid_field.hpp"
#include "methods/radius_method.hpp"

namespace impinge::lab {

// The cube that holds ball and socket in the pose of the scene.
DistanceGridShape grid_shape(const BenchmarkScene& scene, std::size_t nodes);

// Distances (mm, without sign, in float) by cgal_closest at every node. Points outside of the cube get NaN.
// std::invalid_argument for fewer than 2 nodes or no width.
std::unique_ptr<RadiusMethod> make_distance_grid(const TriangleMesh& mesh, const DistanceGridShape& shape);

// Proven bound on the error of an answer, mm: see above.
double distance_grid_bound(const DistanceGridShape& shape);

}  // namespace impinge::lab
