// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Fills a table by exact rasterisation: each face writes r = n.v0 / (n.u) to the entries that its edge
/// planes enclose. As the test is one on unit vectors, poles and seams need no care. Takes O(faces +
/// entries).
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "table/layer.hpp"

namespace impinge {

/// The table of `mesh`, which is in the centre frame. It equals the table of fill_pairwise() but for the
/// rounding of r. Faces whose plane holds the centre cover no direction and are left out. Throws
/// std::invalid_argument for lengths outside of the range of mesh/lengths.hpp. For schemes of the library;
/// for your own include own_scheme.hpp.
template <SamplingScheme S>
RadialTable<S> fill_exact(const TriangleMesh& mesh, const S& scheme, Layer layer);

}  // namespace impinge
