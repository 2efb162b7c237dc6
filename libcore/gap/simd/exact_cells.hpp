// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Cells that know their faces: the gap of the mesh itself, not of a table of it, with vector instructions.
///
/// A face in the plane m . p = 1 has the inverse depth s = m . x in the direction of x, and the gap there is
///   gap = +- |x| (1 / s - 1).
/// A grid on a cube lists the faces that may be met in each of its cells.
///
/// In a cell without an edge at which the surface ends or folds (mesh/jump_edges.hpp), each layer that is
/// there covers the whole cell. Faces of one layer that share an edge or a corner share a radius there. So
/// those that overlapping ranges of radii link to the nearest face are whole layers, all others lie behind
/// them, and only they are kept; for the farthest layer likewise. Then two kinds of cells answer:
///
/// Smooth cells keep at most eight faces, cover all of their directions, and bend one way: no corner of a
/// face lies beyond the plane of another (m . v <= 1 for all of them), or none lies within it. Then the face
/// that is met is the one of largest s (of least s), whatever the edges are: a direction is a sum of the
/// corners of its face with shares that are not negative, so that m_g . x <= m_f . x for all others g.
/// Nothing is decided, and no vertex slips through an edge. The test allows 1 + 2^-26, for faces in one
/// plane. Up to four planes are in the cell itself.
///
/// Other cells (at a rim, a saddle, a fold) test all of their faces, eight at once: a face is met if the
/// three planes through the centre and its edges have x on the inner side. Their unit normals e are floats,
/// so that |fl(e . x) - e . x| is below 4.1 u |x|, u = 2^-24. Beyond 5 u |x| the sign is that of exact
/// arithmetic; within it the vertex is in doubt and exact_gap() answers, whose signs are exact. No face
/// answers in the place of its neighbour, and slivers, which are all doubt, are met or missed as they should
/// be. Where faces overlap, the layer decides.
///
/// Rounding. At the moved vertex x (see gap_kernels.hpp for how far from its place that is) a gap is off from
/// that of the mesh by at most
///   u (18 r + 8 |gap|)
/// m . x has 4 roundings of |m_i x_i| each, together at most 4 u |m| |x| = 4 u s / cos psi, and r = |x| / s
/// takes over what s is off by, relative. Where a face is met that is seen more steeply than 1 / cos psi = 4,
/// exact_gap() answers, in double: beyond tan psi = 1e8 that leaves 84 2^-53 (1 + tan psi) r instead of 18 u
/// r. In smooth cells no plane is that steep at any corner of the others either, so that it cannot win by
/// more than such roundings where it is not met. The rest is what a smooth cell allows, |x| (2.5 u) and three
/// roundings of the gap.
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

/// One cell, a cache line. Planes coordinate by coordinate, 1 / mm; one that is left over is a copy.
struct alignas(64) ExactCell {
  static constexpr std::size_t kPlanes = 4;  // of a smooth cell that needs no more memory

  std::array<std::array<float, kPlanes>, 3> plane{};  // m of a smooth cell, or -m where the least s counts
  std::uint32_t first = 0;  // from 1, what a cell needs more: of a smooth one wide[first - 1] ...
  std::uint32_t count = 0;  // ... and of others blocks[first - 1] ... blocks[first - 2 + count]
};

/// Eight planes coordinate by coordinate, as in a cell. Places that are left over hold the last one once
/// more.
struct WidePlanes {
  static constexpr std::size_t kPlanes = 8;
  using Row = std::array<float, kPlanes>;  // a number of each

  std::array<Row, 3> plane;
};

/// Eight faces, likewise.
struct alignas(64) FaceBlock {
  static constexpr std::size_t kFaces = WidePlanes::kPlanes;  // faces of a block
  using Row = WidePlanes::Row;

  std::array<std::array<Row, 3>, 3> edge;  // inner unit normal of the plane through the centre and edge k
  std::array<Row, 3> plane;  // m, 1 / mm; -m for the farthest layer; 0 of a face that is too steep
};

/// Plain data; make it with exact_cells().
struct ExactCells {
  using Real = float;  // that a kernel works in

  const TriangleMesh& mesh;         // centre frame
  Layer layer;                      // that counts where faces overlap
  std::size_t divisions = 0;        // cells along an edge of the cube
  std::vector<ExactCell> cells;     // each at the entry of `cube_gnomonic` that it begins at
  std::vector<std::uint32_t> none;  // one bit a cell: no face is met there
  std::vector<WidePlanes> wide;     // of smooth cells
  std::vector<FaceBlock> blocks;    // of others, cell by cell
  std::vector<std::uint32_t> face;  // of the mesh, that place 8 b + k of the blocks holds

  /// Beside the mesh.
  std::size_t bytes() const {
    return sizeof(ExactCell) * cells.size() + sizeof(WidePlanes) * wide.size() +
           sizeof(FaceBlock) * blocks.size() + sizeof(std::uint32_t) * (none.size() + face.size());
  }
};

/// mesh in the centre frame; it must outlive the cells. Faces whose plane holds the centre cover no
/// direction. Linear in faces to make. Fewer cells a face take less memory, but more of them are not smooth:
/// slower scans. std::invalid_argument for lengths beyond those of floats in mesh/lengths.hpp.
ExactCells exact_cells(const TriangleMesh& mesh, Layer layer, double cells_a_face = 4.0);
ExactCells exact_cells(TriangleMesh&&, Layer, double = 4.0) = delete;

/// Gap of a vertex of `scanned` at x in the frame of the mesh, mm, in double; NaN where no face is met. In a
/// cell that is not smooth, which faces are met is decided exactly.
double exact_gap(const ExactCells& cells, std::size_t cell, const Vec3& x, Surface scanned);

/// As scan_gaps() of gap_kernels.hpp.
void scan_gaps(const ExactCells& cells, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, std::span<float> gap);

}  // namespace impinge
