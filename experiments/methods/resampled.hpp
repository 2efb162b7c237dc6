// SPDX-License-Identifier: GPL-3.0-or-later
// Filling a table as the thesis fills its helix quickly (Section 4.2.2): the raster of the thesis draws an
// RSID table of the same precision, each entry reads that table by bilinear interpolation, and the RSID table
// is released. O(faces + entries). Meant for Usid; works for any scheme with directions.
//
// The thesis is silent about the rim. Here an entry whose RSID cell the rim crosses has no surface, since
// it would read a mixture from both sides. The table thus ends up to one RSID cell inside of the rim, and
// its own cells are masked by mask_rim() like those of every other table.
//
// Error. With r_i the exact radii of the taps and R_i those drawn, |R_i - r_i| <= E (thesis_raster_bound), so
// that the value sum w_i R_i of an entry along u errs by at most
//   E + |sum w_i r_i - r(u)| <= E + sum w_i r_i (exp(T_i s) - 1),
// the second term being error_bound_at() of an exactly filled RSID table, s its stencil radius. With T the
// largest tan psi of the mesh and r its largest radius that is nowhere more than E + r (exp(T s) - 1), and
// the roundings of error_bound.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/triangle_mesh.hpp"
#include "methods/thesis_raster.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/layer.hpp"
#include "table/rim.hpp"

namespace impinge::lab {

// The RSID grid that stands in for a scheme of this precision, degrees: the nearest one, whose spacing
// divides 180 degrees. For the helices of Table 6 it is the grid that the thesis compares them with.
inline Rsid raster_for(double precision_deg) {
  return Rsid::with_precision(180.0 / std::max(std::round(180.0 / precision_deg), 2.0));
}

// Sets every entry of an existing table from the raster; kNoSurface where the raster has no surface.
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

// Raster, resampling and rim mask together; mesh in the centre frame.
template <SamplingScheme S>
RadialTable<S> fill_resampled(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  RadialTable<S> table = resample(fill_thesis(mesh, raster_for(scheme.precision_deg()), layer), scheme);
  mask_rim(mesh, layer, table);
  return table;
}

// Bound on |fill_resampled() - exact radius| at every entry that has a surface, mm, for a scheme of this
// precision; infinite if a face is edge-on. As that of the raster it holds where the surface continues across
// each edge.
double resampling_bound(const TriangleMesh& mesh, double precision_deg);

}  // namespace impinge::lab
