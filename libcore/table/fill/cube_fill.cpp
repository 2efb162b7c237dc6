// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/cube_fill.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "mesh/lengths.hpp"
#include "sphere/stored_values.hpp"
#include "table/fill/cube_rim.hpp"
#include "table/fill/thread_team.hpp"
#include "table/fill/tile_bins.hpp"
#include "table/fill/tile_painter.hpp"
#include "table/local_refill.hpp"

namespace impinge {
namespace {

CubeView view_of(const TriangleMesh& mesh, const CubeFill& fill) {
  CubeView view(mesh, fill.scheme.divisions());
  const auto threads = static_cast<std::size_t>(fill.threads);
  on_threads(threads, [&](std::size_t thread) {
    const Share vertices = share_of(mesh.vertices.size(), thread, threads);
    view.see(vertices.first, vertices.end);
  });
  return view;
}

void require_fill(const TriangleMesh& mesh, const CubeFill& fill) {
  require_lengths(mesh);
  require_packed_entries(fill.scheme.size());
  if (fill.threads < 1) throw std::invalid_argument("a table is filled by one thread or more");
}

// From a float below the least number to above the most.
template <class Value>
void set_steps(const DepthRange& range, PackedTable<CubeGnomonic, Value>& table) {
  static_cast<void>(FloatValues(std::array{range.least, range.most}));  // its checks
  if constexpr (std::same_as<Value, std::uint16_t>) {
    const float below = std::nextafter(static_cast<float>(range.least), 0.0F);
    table.smallest = static_cast<double>(below);
    table.step = (range.most * (1.0 + 0x1p-22) - table.smallest) / (Uint16Values::kNone - 1);
  }
}

template <class Value>
void set_up(const CubeFill& fill, PackedTable<CubeGnomonic, Value>& table) {
  table.divisions = fill.scheme.divisions();
  table.stride = table.divisions + 1;
  table.values.resize(fill.scheme.size());
  table.none.clear();
}

// Paints the tiles for which `wanted` says so, and then the rim, whose edges the first thread finds before it
// takes its share of the tiles.
template <class Value, class Wanted>
void paint(const PaintTask<Value>& task, const TileBins& bins, int threads, const Wanted& wanted) {
  std::vector<JumpEdge> jumps;
  std::atomic<std::size_t> next{0};
  on_threads(static_cast<std::size_t>(threads), [&](std::size_t thread) {
    if (thread == 0) jumps = jump_edges(task.view.mesh(), bins.sides);
    TilePainter<Value> painter(task);
    for (std::size_t tile = next++; tile < task.tiling.size(); tile = next++)
      if (wanted(tile)) painter.paint(tile, bins[tile]);
  });
  mark_rim(RimTask<Value>{task.view.mesh(), task.scheme, task.layer, task.table}, jumps);
}

// Takes the marks from the cells of these tiles; says how many entries they keep.
template <class Value>
std::size_t unmask(const CubeTiling& tiling, const std::vector<bool>& tiles,
                   PackedTable<CubeGnomonic, Value>& table) {
  std::size_t entries = 0;
  for (std::size_t t = 0; t < tiling.size(); ++t) {
    if (!tiles[t]) continue;
    const CubeTile tile = tiling[t];
    entries += tile.rows * tile.columns;
    for (std::size_t row = tile.first_row; row < tile.first_row + tile.rows && !table.none.empty(); ++row) {
      const std::size_t first = (tile.face * table.stride + row) * table.stride + tile.first_column;
      for (std::size_t e = first; e < first + tile.columns; ++e) table.none[e / 32] &= ~(1U << (e % 32));
    }
  }
  return entries;
}

}  // namespace

template <PackedValue Value>
void fill_cube(const TriangleMesh& mesh, const CubeFill& fill, PackedTable<CubeGnomonic, Value>& table) {
  require_fill(mesh, fill);
  const CubeView view = view_of(mesh, fill);
  const CubeTiling tiling(view.divisions());
  const TileBins bins = tile_bins(view, tiling, static_cast<std::size_t>(fill.threads));
  set_up(fill, table);
  set_steps(fill.room.most > 0.0 ? fill.room : bins.range, table);
  std::once_flag made;
  paint(PaintTask<Value>{view, tiling, fill.scheme, fill.layer, table, made}, bins, fill.threads,
        [](std::size_t) { return true; });
}

template <PackedValue Value>
std::size_t refill_cube(const TriangleMesh& before, const TriangleMesh& after, const CubeFill& fill,
                        PackedTable<CubeGnomonic, Value>& table) {
  require_fill(after, fill);
  if (table.values.size() != fill.scheme.size())
    throw std::invalid_argument("the table to refill is not of this scheme: fill it anew");
  const std::vector<std::size_t> changed = changed_faces(before, after);
  if (changed.empty()) return 0;
  const CubeView view = view_of(after, fill);
  const CubeTiling tiling(view.divisions());
  const TileBins bins = tile_bins(view, tiling, static_cast<std::size_t>(fill.threads));
  PackedTable<CubeGnomonic, Value> anew;
  set_steps(fill.room.most > 0.0 ? fill.room : bins.range, anew);
  if (anew.smallest != table.smallest || anew.step != table.step) {
    fill_cube(after, fill, table);
    return table.values.size();
  }
  std::vector<bool> marked(tiling.size());
  mark_tiles(view_of(before, fill), tiling, changed, marked);
  mark_tiles(view, tiling, changed, marked);
  const std::size_t worked_out = unmask(tiling, marked, table);
  std::once_flag made;
  paint(PaintTask<Value>{view, tiling, fill.scheme, fill.layer, table, made}, bins, fill.threads,
        [&marked](std::size_t tile) { return marked[tile]; });
  if (std::ranges::none_of(table.none, [](auto word) { return word != 0; })) table.none.clear();
  return worked_out;
}

template void fill_cube(const TriangleMesh&, const CubeFill&, PackedTable<CubeGnomonic, float>&);
template void fill_cube(const TriangleMesh&, const CubeFill&, PackedTable<CubeGnomonic, std::uint16_t>&);
template std::size_t refill_cube(const TriangleMesh&, const TriangleMesh&, const CubeFill&,
                                 PackedTable<CubeGnomonic, float>&);
template std::size_t refill_cube(const TriangleMesh&, const TriangleMesh&, const CubeFill&,
                                 PackedTable<CubeGnomonic, std::uint16_t>&);

}  // namespace impinge
