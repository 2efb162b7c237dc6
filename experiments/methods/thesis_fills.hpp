// SPDX-License-Identifier: GPL-3.0-or-later
// Ways in which the thesis fills its tables besides its raster, and how it compares (Algorithm 2).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "gap/surface.hpp"
#include "mesh/triangle_mesh.hpp"
#include "methods/thesis_raster.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/layer.hpp"
#include "table/rim.hpp"

namespace impinge::lab {

// The pairwise sampling with which the thesis compares (Section 3.2, Table 3): "scan and test each
// sampling ray against points inside area of all triangles to find out the exact interfered triangle with the
// ray and then sample the distance", O(m n). It is done literally: each pair of a ray and a triangle by
// itself, with nothing prepared and nothing skipped. The ray meets the plane of the triangle in a point x = r
// u, r = n.a / (n.u). x is inside if the areas of the three triangles that it makes with the edges add up to
// the triangle's area. The thesis does not print its test; RayCaster (table/pairwise.hpp) does the same work
// with edge planes that are prepared once per face, and with exact signs.

// How much larger than the triangle's area the sum of the three areas may be for x to count as inside, as a
// share of it. It allows for rounding at points on an edge, and is far less than a face.
inline constexpr double kAreaSlack = 1e-9;

// Radius along a unit vector u (mm); kNoSurface if no triangle is met. `mesh` is in the centre frame. Equal
// to RayCaster's within rounding, except for rays within about kAreaSlack of a face at a rim and for faces
// seen edge-on.
double thesis_ray_radius(const TriangleMesh& mesh, const Vec3& u, Layer layer);

// A table filled with thesis_ray_radius(), with its rim masked.
template <SamplingScheme S>
RadialTable<S> fill_thesis_pairwise(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  RadialTable<S> table(scheme);
  for (std::size_t i = 0; i < scheme.size(); ++i)
    table.radii()[i] = thesis_ray_radius(mesh, scheme.direction(i), layer);
  mask_rim(mesh, layer, table);
  return table;
}

// The comparison of the thesis' Algorithms 2 and 3 as they are written, and the signed gap.

// How many vertices of a scan each of the two calls impinged.
struct ScanVerdicts {
  std::size_t met = 0;         // vertices that meet the other surface
  std::size_t by_gap = 0;      // of these, with a gap of 0 or less
  std::size_t as_written = 0;  // of these, with d <= d_i: d from the table, d_i of the vertex
};

// `gap` is in mm, NaN where no surface is met, as from scan_gaps(): d - d_i for vertices of the ball, d_i - d
// for vertices of the socket. The thesis applies the same comparison d <= d_i to both.
ScanVerdicts compare_as_written(std::span<const double> gap, Surface scanned);

// Fills a table as the thesis fills its helix quickly (Section 4.2.2): the thesis' raster draws an RSID table
// of the same precision, each entry reads that table by bilinear interpolation, and the RSID table is
// released. O(faces + entries). Meant for Usid; works for any scheme with directions.
//
// The thesis says nothing about the rim. Here an entry has no surface if the rim crosses its RSID cell, since
// it would read a mixture from both sides. So the table ends up to one RSID cell inside the rim; its own
// cells are masked by mask_rim() as in every other table.
//
// Error. With exact radii r_i of the taps and drawn radii R_i, |R_i - r_i| <= E (thesis_raster_bound). The
// value sum w_i R_i of an entry along u therefore errs by at most
//   E + |sum w_i r_i - r(u)| <= E + sum w_i r_i (exp(T_i s) - 1),
// whose second term is error_bound_at() of an exactly filled RSID table with stencil radius s. With the
// largest tan psi of the mesh, T, and its largest radius, r, this is nowhere more than E + r (exp(T s) - 1),
// plus the rounding in error_bound.hpp.

// The RSID grid that stands in for a scheme of this precision, degrees: the nearest grid whose spacing
// divides 180 degrees. For the helices of Table 6 it is the grid with which the thesis compares them.
inline Rsid raster_for(double precision_deg) {
  return Rsid::with_precision(180.0 / std::max(std::round(180.0 / precision_deg), 2.0));
}

// Sets every entry of a table from the raster; kNoSurface where the raster has no surface.
template <SamplingScheme S>
void read_raster(const RadialTable<Rsid>& raster, RadialTable<S>& table) {
  const auto radii = table.radii();
  for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = raster.radius_at(table.scheme().direction(i));
}

// A new table, set by read_raster().
template <SamplingScheme S>
RadialTable<S> resample(const RadialTable<Rsid>& raster, const S& scheme) {
  RadialTable<S> table(scheme);
  read_raster(raster, table);
  return table;
}

// Raster, resampling and rim mask together; `mesh` is in the centre frame.
template <SamplingScheme S>
RadialTable<S> fill_resampled(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  RadialTable<S> table = resample(fill_thesis(mesh, raster_for(scheme.precision_deg()), layer), scheme);
  mask_rim(mesh, layer, table);
  return table;
}

// Bound on |fill_resampled() - exact radius| at every entry with a surface, mm, for a scheme of this
// precision; infinite if a face is edge-on. Like the raster's bound it holds where the surface continues
// across each edge.
double resampling_bound(const TriangleMesh& mesh, double precision_deg);

}  // namespace impinge::lab
