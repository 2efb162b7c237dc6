// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Filling a table by exact rasterisation: each face writes r = n.v0 / (n.u) to the entries that its edge
/// planes enclose. No pole, no seam and no distortion: the test is one on unit vectors. O(faces + entries).
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "table/layer.hpp"

namespace impinge {

/// mesh in the centre frame. Equal to fill_pairwise() but for the rounding of r; faces whose plane holds the
/// centre cover no direction and are left out. std::invalid_argument for lengths beyond those of
/// mesh/lengths.hpp. Of schemes of the library; for one of your own see own_scheme.hpp.
template <SamplingScheme S>
RadialTable<S> fill_exact(const TriangleMesh& mesh, const S& scheme, Layer layer);

}  // namespace impinge
