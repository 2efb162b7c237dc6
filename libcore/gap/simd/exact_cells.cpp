// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/exact_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gap/simd/face_block.hpp"
#include "gap/simd/face_order.hpp"
#include "gap/simd/hit_cells.hpp"
#include "gap/simd/open_cells.hpp"
#include "gap/simd/seen_planes.hpp"
#include "mesh/lengths.hpp"
#include "table/face_cap.hpp"

namespace impinge {
namespace {

constexpr double kMostCells = 2048.0;  // along an edge of the cube

// Share of the sphere that the faces cover, each by itself; the flat triangle between unit corners stands for
// the round one.
double covered_share(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = corner(mesh, face, 0).stableNormalized();
    const Vec3 b = corner(mesh, face, 1).stableNormalized();
    const Vec3 c = corner(mesh, face, 2).stableNormalized();
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return std::clamp(area / (4.0 * kPi), 1.0 / 64.0, 1.0);
}

std::size_t divisions_for(const TriangleMesh& mesh, double cells_a_face) {
  const double cells = cells_a_face * static_cast<double>(mesh.faces.size()) / covered_share(mesh);
  return static_cast<std::size_t>(std::clamp(std::round(std::sqrt(cells / 6.0)), 1.0, kMostCells));
}

// In a cell that each layer of a mesh covers or leaves alone, the faces of the layer that counts.
class FrontFaces {
 public:
  FrontFaces(const TriangleMesh& mesh, std::span<const std::uint32_t> order, Layer layer) {
    for (const std::uint32_t f : order) {
      const RadiusRange range = face_cap(corners_of(mesh, mesh.faces[f])).range;
      depth_.push_back(layer == Layer::nearest ? range : RadiusRange{-range.high, -range.low});
    }
  }

  // Those of these places, one or more, both in rising order; until the next call.
  std::span<const std::uint32_t> among(std::span<const std::uint32_t> places) {
    kept_.assign(places.begin(), places.end());
    std::ranges::sort(kept_, {}, [&](std::uint32_t place) { return depth_[place].low; });
    double end = depth_[kept_.front()].high;
    const auto beyond = std::ranges::find_if(kept_, [&](std::uint32_t place) {
      const bool linked = depth_[place].low <= end;
      end = std::max(end, depth_[place].high);
      return !linked;
    });
    kept_.erase(beyond, kept_.end());
    std::ranges::sort(kept_);
    return kept_;
  }

 private:
  std::vector<RadiusRange> depth_;  // of each place, mm: less is nearer to the layer that counts
  std::vector<std::uint32_t> kept_;
};

void set_planes(const std::vector<Vec3>& planes, std::span<const std::uint32_t> faces, int turn,
                ExactCell& cell) {
  cell.turn = static_cast<float>(turn);
  for (std::size_t k = 0; k < ExactCell::kPlanes; ++k) {
    const Vec3& plane = planes[faces[std::min(k, faces.size() - 1)]];
    for (std::size_t i = 0; i < 3; ++i)
      cell.plane[i][k] = static_cast<float>(turn * plane[static_cast<Eigen::Index>(i)]);
  }
}

// The blocks of these places.
void list_blocks(std::span<const std::uint32_t> places, ExactCell& cell, ExactCells& made) {
  cell.turn = made.layer == Layer::nearest ? 1.0F : -1.0F;
  cell.first = static_cast<std::uint32_t>(made.listed.size());
  for (const std::uint32_t place : places) {
    const auto block = static_cast<std::uint32_t>(place / FaceBlock::kFaces);
    if (made.listed.size() == cell.first || made.listed.back() != block) made.listed.push_back(block);
  }
  cell.count = static_cast<std::uint32_t>(made.listed.size()) - cell.first;
}

}  // namespace

ExactCells exact_cells(const TriangleMesh& mesh, Layer layer, double cells_a_face) {
  require_float_lengths(mesh);
  ExactCells made{mesh, layer, divisions_for(mesh, cells_a_face), {}, {}, {}, {}, faces_along_curve(mesh)};
  const std::size_t lines = made.divisions + 1;
  made.cells.resize(6 * lines * lines, ExactCell{{}, std::numeric_limits<float>::quiet_NaN()});
  const std::vector<Vec3> planes = seen_planes(mesh);
  made.blocks = face_blocks({mesh, planes}, made.face, layer);
  const CellGrid grid = float_grid(made.divisions);
  const Lists faces = faces_of_cells(mesh, made.face, grid);
  const std::vector<bool> open = open_cells(mesh, grid);
  FrontFaces front(mesh, made.face, layer);
  made.none.resize(made.cells.size() / 32 + 1);
  std::vector<std::uint32_t> few;
  for (std::size_t c = 0; c < made.cells.size(); ++c) {
    if (faces[c].empty()) {
      made.none[c / 32] |= 1U << (c % 32);
      continue;
    }
    const auto places = open[c] ? faces[c] : front.among(faces[c]);
    few.clear();
    if (places.size() <= ExactCell::kPlanes && !open[c])
      for (const std::uint32_t place : places) few.push_back(made.face[place]);
    const auto bend = bend_of({mesh, planes}, few);
    if (!few.empty() && bend) {
      set_planes(planes, few, *bend, made.cells[c]);
    } else {
      list_blocks(places, made.cells[c], made);
    }
  }
  return made;
}

}  // namespace impinge
