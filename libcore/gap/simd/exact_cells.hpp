// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells that know their faces: they give the gap of the mesh itself, not of a table, with vector
/// instructions.
///
/// A grid on a cube lists the faces that may be met in each of its cells. A face in the plane m . p = 1 has
/// the inverse depth s = m . x in the direction of x, and the gap there is +- |x| (1 / s - 1). As the remark
/// after Theorem 5 (gap) shows, a cell without an edge at which the surface ends or folds
/// (mesh/jump_edges.hpp) keeps only the faces in front, and there are two kinds of cells:
///   smooth   at most eight faces that cover the cell and bend one way: no corner of a face lies beyond the
///            plane of another, or none within it. The face with the largest (the least) s is met, whatever
///            the edges are. The test allows 1 + 2^-26, for faces in one plane. Up to four planes are in the
///            cell.
///   others   at a rim, a saddle or a fold: all faces are tested, eight at once. A face is met if x is on the
///            inner side of the three planes through the centre and its edges, whose unit normals e are
///            floats: e . x is off by less than 4.1 u |x|, u = 2^-24. Within 5 u |x| the vertex is in doubt,
///            and exact_gap() decides by exact signs. Where faces overlap, the layer decides.
///
/// Rounding. At the moved vertex x (gap_kernels.hpp says how far that is from its place) the error of a gap
/// is at most u (18 r + 8 |gap|). The sum m . x is off by 4 u |m| |x| = 4 u s / cos psi, and r = |x| / s by
/// the same share; a smooth cell allows 2.5 u |x| more, and the gap has three roundings. Where a face is met
/// that is seen more steeply than 1 / cos psi = 4, exact_gap() answers in double: beyond tan psi = 1e8 that
/// leaves 84 2^-53 (1 + tan psi) r instead of 18 u r. In a smooth cell no plane is that steep at a corner of
/// another face either, so that it cannot win by more than such roundings where it is not met.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gap/simd/gap_kernels.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge {

/// One cell, as large as a cache line. Planes are stored coordinate by coordinate, in 1 / mm; unused places
/// hold copies.
struct alignas(64) ExactCell {
  static constexpr std::size_t kPlanes = 4;  // most planes of a smooth cell that needs no more memory

  std::array<std::array<float, kPlanes>, 3> plane{};  // m of a smooth cell, or -m where the least s counts
  std::uint32_t first = 0;  // 0, or 1 + where the rest is: of a smooth cell wide[first - 1],
  std::uint32_t count = 0;  // of others blocks[first - 1] to blocks[first - 2 + count]
};

/// Eight planes, coordinate by coordinate, as in a cell. Unused places hold copies of the last one.
struct WidePlanes {
  static constexpr std::size_t kPlanes = 8;
  using Row = std::array<float, kPlanes>;  // one number of each plane

  std::array<Row, 3> plane;
};

/// Eight faces, coordinate by coordinate.
struct alignas(64) FaceBlock {
  static constexpr std::size_t kFaces = WidePlanes::kPlanes;  // faces of a block
  using Row = WidePlanes::Row;

  std::array<std::array<Row, 3>, 3> edge;  // inner unit normal of the plane through the centre and edge k
  std::array<Row, 3> plane;  // m, 1 / mm; -m for the farthest layer; 0 for a face that is too steep
};

/// Plain data, made by exact_cells().
struct ExactCells {
  using Real = float;  // the kernel works in this

  const TriangleMesh& mesh;         // centre frame
  Layer layer;                      // that counts where faces overlap
  std::size_t divisions = 0;        // cells along an edge of the cube
  std::vector<ExactCell> cells;     // by the entry of `cube_gnomonic` at which a cell begins
  std::vector<std::uint32_t> none;  // a bit for each cell, 1 if no face is met there
  std::vector<WidePlanes> wide;     // of smooth cells
  std::vector<FaceBlock> blocks;    // of other cells, cell by cell
  std::vector<std::uint32_t> face;  // number in the mesh of face k of block b, at 8 b + k

  /// Bytes of memory, without the mesh.
  std::size_t bytes() const {
    return sizeof(ExactCell) * cells.size() + sizeof(WidePlanes) * wide.size() +
           sizeof(FaceBlock) * blocks.size() + sizeof(std::uint32_t) * (none.size() + face.size());
  }
};

/// The cells of `mesh`, which is in the centre frame and must outlive them; made in O(faces). Faces whose
/// plane holds the centre cover no direction. Fewer cells for each face take less memory, but more of them
/// are not smooth, so that scans are slower. Throws std::invalid_argument for lengths outside of the range of
/// floats in mesh/lengths.hpp.
ExactCells exact_cells(const TriangleMesh& mesh, Layer layer, double cells_a_face = 4.0);
ExactCells exact_cells(TriangleMesh&&, Layer, double = 4.0) = delete;

/// Gap of a vertex of `scanned` at x in the frame of the mesh, mm, in double; NaN if no face is met. In a
/// cell that is not smooth it is decided exactly which faces are met.
double exact_gap(const ExactCells& cells, std::size_t cell, const Vec3& x, Surface scanned);

/// Writes the gaps of the vertices to `gap`, as scan_gaps() of gap_kernels.hpp does.
void scan_gaps(const ExactCells& cells, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, std::span<float> gap);

}  // namespace impinge
