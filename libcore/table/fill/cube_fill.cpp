// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/cube_fill.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "files/thread_team.hpp"
#include "mesh/lengths.hpp"
#include "sphere/stored_values.hpp"
#include "table/fill/cube_rim.hpp"
#include "table/fill/tile_bins.hpp"
#include "table/fill/tile_painter.hpp"

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

// Paints the tiles, and then the rim, whose edges the first thread finds before it takes its share of the
// tiles.
template <class Value>
void paint(const PaintTask<Value>& task, const TileBins& bins, int threads) {
  std::vector<JumpEdge> jumps;
  std::atomic<std::size_t> next{0};
  on_threads(static_cast<std::size_t>(threads), [&](std::size_t thread) {
    if (thread == 0) jumps = jump_edges(task.view.mesh(), bins.sides);
    TilePainter<Value> painter(task);
    for (std::size_t tile = next++; tile < task.tiling.size(); tile = next++) painter.paint(tile, bins[tile]);
  });
  mark_rim(RimTask<Value>{task.view.mesh(), task.scheme, task.layer, task.table}, jumps);
}

}  // namespace

template <PackedValue Value>
void fill_cube(const TriangleMesh& mesh, const CubeFill& fill, PackedTable<CubeGnomonic, Value>& table) {
  require_fill(mesh, fill);
  const CubeView view = view_of(mesh, fill);
  const CubeTiling tiling(view.divisions());
  const TileBins bins = tile_bins(view, tiling, static_cast<std::size_t>(fill.threads));
  set_up(fill, table);
  set_steps(bins.range, table);
  std::once_flag made;
  paint(PaintTask<Value>{view, tiling, fill.scheme, fill.layer, table, made}, bins, fill.threads);
}

template void fill_cube(const TriangleMesh&, const CubeFill&, PackedTable<CubeGnomonic, float>&);
template void fill_cube(const TriangleMesh&, const CubeFill&, PackedTable<CubeGnomonic, std::uint16_t>&);

}  // namespace impinge
