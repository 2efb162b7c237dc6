// SPDX-License-Identifier: GPL-3.0-or-later
// The pairwise sampling that the thesis compares with (Section 3.2, Table 3): "scan and test each sampling
// ray against points inside area of all triangles to find out the exact interfered triangle with the ray and
// then sample the distance", O(m n).
//
// Done literally: each pair of a ray and a triangle by itself, nothing prepared, nothing passed over. The ray
// meets the plane of the triangle in a point x = r u, r = n.a / (n.u), and x is inside when the areas of the
// three triangles that it makes with the edges add up to that of the triangle. The thesis does not print its
// test; RayCaster (table/pairwise.hpp) does the same work by edge planes that are prepared once a face,
// with exact signs.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "table/layer.hpp"
#include "table/rim.hpp"

namespace impinge::lab {

// How much larger than the triangle's area the three areas together may be for x to count as inside, as a
// share of it: allows for rounding at points on an edge, and is far less than a face.
inline constexpr double kAreaSlack = 1e-9;

// Radius along unit u (mm), kNoSurface if no triangle is met. Mesh in the centre frame. Equal to RayCaster's
// within rounding, except for rays within about kAreaSlack of a face at a rim and for faces seen edge-on.
double thesis_ray_radius(const TriangleMesh& mesh, const Vec3& u, Layer layer);

// A table filled by thesis_ray_radius(), with its rim masked.
template <SamplingScheme S>
RadialTable<S> fill_thesis_pairwise(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  RadialTable<S> table(scheme);
  for (std::size_t i = 0; i < scheme.size(); ++i)
    table.radii()[i] = thesis_ray_radius(mesh, scheme.direction(i), layer);
  mask_rim(mesh, layer, table);
  return table;
}

}  // namespace impinge::lab
