// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Filling a table by exact rasterisation: each face writes r = n.v0 / (n.u) to the entries that its edge
/// planes enclose. No pole, no seam and no distortion: the test is one on unit vectors. O(faces + entries).
#pragma once

#include <cstddef>

#include "mesh/lengths.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/walker.hpp"
#include "table/layer.hpp"
#include "table/rim.hpp"

namespace impinge {

/// mesh in the centre frame. Equal to fill_pairwise() but for the rounding of r; faces whose plane holds the
/// centre cover no direction and are left out. std::invalid_argument for lengths beyond those of
/// mesh/lengths.hpp.
template <SamplingScheme S>
RadialTable<S> fill_exact(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  require_lengths(mesh);
  RadialTable<S> table(scheme);
  const auto radii = table.radii();
  const auto& walker = walker_of(scheme);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    for_each_entry_inside(
        walker, cone, [&](std::size_t entry, const Vec3& u) { keep(radii[entry], cone.radius(u), layer); });
  }
  mask_rim(mesh, layer, table);
  return table;
}

/// Compiled once for the schemes of the library, in table/exact_raster.cpp.
#define IMPINGE_FILL(S) extern template RadialTable<S> fill_exact(const TriangleMesh&, const S&, Layer);
IMPINGE_SCHEMES(IMPINGE_FILL)
#undef IMPINGE_FILL

}  // namespace impinge
