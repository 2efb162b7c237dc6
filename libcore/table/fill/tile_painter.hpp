// SPDX-License-Identifier: GPL-3.0-or-later
// Filling one tile after the other of a table: what one thread does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>

#include "table/fill/cube_view.hpp"
#include "table/fill/raster_tile.hpp"
#include "table/packed_table.hpp"

namespace impinge {

/// What all threads share. Each tile belongs to one thread, but tiles share words of the mask: these are set
/// atomically, and the mask is made when it is first needed.
template <PackedValue Value>
struct PaintTask {
  const CubeView& view;                     // of the mesh, all of whose corners have been seen
  const CubeTiling& tiling;                 // of the table
  const CubeGnomonic& scheme;               // of the table
  Layer layer;                              // which crossing counts where faces overlap
  PackedTable<CubeGnomonic, Value>& table;  // that is filled
  std::once_flag& mask_made;                // of the table's mask
};

/// Keeps the memory of a tile while it goes from one to the next.
template <PackedValue Value>
class TilePainter {
 public:
  explicit TilePainter(const PaintTask<Value>& task) : task_(task) {}  // the task must outlive this

  /// `faces` of the mesh hold all that may be seen in the tile.
  void paint(std::size_t tile, std::span<const std::uint32_t> faces);

 private:
  void add(std::uint32_t face);
  void add(std::uint32_t face, const std::array<const SeenCorner*, 3>& corners);
  void draw_added();
  void draw_exactly(std::uint32_t face, const GridWindow& window);
  void store();
  void mark_cells(std::size_t row, std::uint64_t cells);
  bool covers(std::uint32_t face, std::size_t column, std::size_t row);
  const TriangleCone& cone(std::uint32_t face);
  std::size_t entry(std::size_t column, std::size_t row) const;

  const PaintTask<Value>& task_;
  CubeTile tile_;
  CornerBatch corners_;  // of faces that are not drawn yet
  TileTriangles triangles_;
  std::optional<TriangleCone> cone_;  // of the face that was asked last
  std::uint32_t cone_face_ = 0;
  TileCanvas canvas_;
};

}  // namespace impinge
