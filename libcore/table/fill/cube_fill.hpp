// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From a mesh to the table that a kernel reads, in one go and with several threads. Faces are drawn as
/// straight-edged triangles on the faces of the cube, in tiles of 64 x 64 entries that fit a core's first
/// cache; a finished tile is stored in float or 16 bits. The memory of the table is touched once, by the
/// thread that fills it. The bytes do not depend on the number of threads, the instruction set or the order
/// of faces.
///
/// Compared with packed_table(fill_exact(mesh, scheme, layer)), q its number before storage:
///   - the same entries have a surface: what float leaves in doubt is decided exactly
///   - float       |stored - q| <= 41 u q                          u = 2^-24 (tile_triangle.hpp)
///   - 16 bits     |stored - q| <= 0.51 step + 41 u q              step from the corners of the faces
///   - a cell without an answer there has none here; a rim cell that answers there only by less than the
///     rounding of storage may have none here
/// O(faces + entries).
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"
#include "table/packed_table.hpp"

namespace impinge {

struct CubeFill {
  CubeGnomonic scheme;            // whose entries are filled
  Layer layer = Layer::farthest;  // which crossing counts where a direction meets several
  int threads = 1;                // one or more
};

/// mesh in the centre frame. std::invalid_argument for lengths beyond those of mesh/lengths.hpp, more entries
/// than a kernel can read, numbers that a float cannot hold, and less than one thread. The memory of `table`
/// is reused. Value is float or std::uint16_t.
template <PackedValue Value>
void fill_cube(const TriangleMesh& mesh, const CubeFill& fill, PackedTable<CubeGnomonic, Value>& table);

}  // namespace impinge
