// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A proven and tight bound on the error of a table: the largest |table.radius_at(x) - radius of the mesh
/// along x| over all x that have an answer.
///
/// By Theorem 2 (table). First each patch of the scheme (patches/patch.hpp) gets a bound, the a priori bound,
/// from its errors at the corners and the faces and edges that it may meet (patch_error.hpp). Then the patch
/// with the largest bound is halved until that bound is within `tightness` of the largest error that was
/// evaluated, or the budget ends. Patches of one face converge at second order; those across an edge converge
/// at first order, but only along the edge.
///
/// A scheme that declares no patches gets a bound of first order. A bound above the largest radius of the
/// surface says nothing and is given as infinite.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/stored_table.hpp"
#include "table/layer.hpp"

namespace impinge {

struct TableBound {
  double bound_mm = 0.0;         // infinite if there is none
  double attained_mm = 0.0;      // largest error that was evaluated
  Vec3 witness = Vec3::UnitZ();  // its direction, unit vector
  double a_priori_mm = 0.0;      // the bound before any patch was halved
};

/// When the search for a bound ends.
struct BoundOptions {
  double tightness = 1.05;         // stop when bound <= tightness * attained
  std::size_t budget = 1'000'000;  // halvings; 0 for the bound a priori
  /// If given: one 0 for each cell of the scheme; receives the a priori bound of each cell that answers, mm.
  /// Ignored for schemes without patches.
  std::vector<float>* of_cells = nullptr;
};

/// The bound of a table that was filled exactly from this mesh (centre frame), for this layer. For schemes of
/// the library; for your own include own_scheme.hpp.
template <SamplingScheme S>
TableBound table_bound(const TriangleMesh& mesh, const RadialTable<S>& table, Layer layer,
                       const BoundOptions& options = {});

/// The same for a table of inverse depths made from such a table. Include own_scheme.hpp to call it.
template <PlaneExactScheme S>
TableBound table_bound(const TriangleMesh& mesh, const InverseDepthTable<S>& table, Layer layer,
                       const BoundOptions& options = {});

}  // namespace impinge
