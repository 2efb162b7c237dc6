// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// From a mesh to the table that a kernel reads, in one go and with several threads: faces are drawn as
/// straight-edged triangles on the faces of the cube, 64 x 64 entries at a time in a core's first cache, each
/// of which is then stored in float or 16 bits. The memory of the table is touched once, by the thread that
/// fills it. Bytes do not depend on the number of threads, on the instruction set or on the order of faces.
///
/// Beside packed_table(fill_exact(mesh, scheme, layer)), q being its number before it is
/// stored:
///   - the same entries have a surface, exactly: what float leaves in doubt is decided as there
///   - float       |stored - q| <= 41 u q                          u = 2^-24 (tile_triangle.hpp)
///   - 16 bits     |stored - q| <= 0.51 step + 41 u q              step from the corners of the faces
///   - a cell without an answer there has none here; rim cells that are left out there by no more than what
///     storage takes from a number may have none in addition
/// O(faces + entries).
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"
#include "table/packed_table.hpp"

namespace impinge {

struct CubeFill {
  CubeGnomonic scheme;            // whose entries are filled
  Layer layer = Layer::farthest;  // that counts where there are several
  int threads = 1;                // one or more
};

/// mesh in the centre frame. std::invalid_argument for lengths beyond those of mesh/lengths.hpp, more entries
/// than a kernel can read, numbers that a float cannot hold, and no thread. The memory of `table` is used
/// again. Value is float or std::uint16_t.
template <PackedValue Value>
void fill_cube(const TriangleMesh& mesh, const CubeFill& fill, PackedTable<CubeGnomonic, Value>& table);

}  // namespace impinge
