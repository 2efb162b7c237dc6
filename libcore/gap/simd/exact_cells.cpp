// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/exact_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/simd/face_block.hpp"
#include "gap/simd/hit_cells.hpp"
#include "gap/simd/open_cells.hpp"
#include "gap/simd/seen_planes.hpp"
#include "mesh/lengths.hpp"
#include "table/face_cap.hpp"

namespace impinge {
namespace {

constexpr double kMostCells = 2048.0;  // along an edge of the cube

// The share of the sphere that the faces cover, each counted by itself. A flat triangle between unit corners
// stands for the spherical one.
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

// Chooses the faces of the layer that counts, in a cell that each layer covers wholly or not at all.
class FrontFaces {
 public:
  FrontFaces(const TriangleMesh& mesh, Layer layer) {
    for (const Face& face : mesh.faces) {
      const RadiusRange range = face_cap(corners_of(mesh, face)).range;
      depth_.push_back(layer == Layer::nearest ? range : RadiusRange{-range.high, -range.low});
    }
  }

  // The chosen of these faces, one or more; valid until the next call.
  std::span<const std::uint32_t> among(std::span<const std::uint32_t> faces) {
    kept_.assign(faces.begin(), faces.end());
    std::ranges::sort(kept_, {}, [&](std::uint32_t f) { return depth_[f].low; });
    double end = depth_[kept_.front()].high;
    const auto beyond = std::ranges::find_if(kept_, [&](std::uint32_t f) {
      const bool linked = depth_[f].low <= end;
      end = std::max(end, depth_[f].high);
      return !linked;
    });
    kept_.erase(beyond, kept_.end());
    return kept_;
  }

 private:
  std::vector<RadiusRange> depth_;  // of each face, mm; less is nearer to the layer that counts
  std::vector<std::uint32_t> kept_;
};

// turn * m of these faces, coordinate by coordinate.
template <std::size_t n>
std::array<std::array<float, n>, 3> rows_of(const std::vector<Vec3>& planes,
                                            std::span<const std::uint32_t> faces, int turn) {
  std::array<std::array<float, n>, 3> rows;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3& plane = planes[faces[std::min(k, faces.size() - 1)]];
    for (std::size_t i = 0; i < 3; ++i)
      rows[i][k] = static_cast<float>(turn * plane[static_cast<Eigen::Index>(i)]);
  }
  return rows;
}

void set_planes(const std::vector<Vec3>& planes, std::span<const std::uint32_t> faces, int turn,
                ExactCell& cell, ExactCells& made) {
  if (faces.size() <= ExactCell::kPlanes) {
    cell.plane = rows_of<ExactCell::kPlanes>(planes, faces, turn);
    return;
  }
  made.wide.push_back({rows_of<WidePlanes::kPlanes>(planes, faces, turn)});
  cell.first = static_cast<std::uint32_t>(made.wide.size());
}

// Adds a block for each eight of these faces.
void add_blocks(std::span<const FaceLane> all, std::span<const std::uint32_t> faces, ExactCell& cell,
                ExactCells& made) {
  const std::size_t before = made.blocks.size();
  cell.first = static_cast<std::uint32_t>(before + 1);
  for (std::size_t k = 0; k < faces.size(); k += FaceBlock::kFaces) {
    const auto some = faces.subspan(k, std::min(FaceBlock::kFaces, faces.size() - k));
    made.blocks.push_back(face_block(all, some));
    for (std::size_t lane = 0; lane < FaceBlock::kFaces; ++lane)
      made.face.push_back(some[std::min(lane, some.size() - 1)]);
  }
  cell.count = static_cast<std::uint32_t>(made.blocks.size() - before);
}

// Faces that cover directions.
std::vector<std::uint32_t> covering_faces(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (!cone_of(mesh, mesh.faces[f]).edge_on()) faces.push_back(f);
  return faces;
}

}  // namespace

ExactCells exact_cells(const TriangleMesh& mesh, Layer layer, double cells_a_face) {
  require_float_lengths(mesh);
  ExactCells made{mesh, layer, divisions_for(mesh, cells_a_face), {}, {}, {}, {}, {}};
  const std::size_t lines = made.divisions + 1;
  made.cells.resize(6 * lines * lines);
  made.none.resize(made.cells.size() / 32 + 1);
  const std::vector<Vec3> planes = seen_planes(mesh);
  const std::vector<FaceLane> all = face_lanes({mesh, planes}, layer);
  const CellGrid grid = float_grid(made.divisions);
  const Lists faces = faces_of_cells(mesh, covering_faces(mesh), grid);
  const std::vector<bool> open = open_cells(mesh, grid);
  FrontFaces front(mesh, layer);
  for (std::size_t c = 0; c < made.cells.size(); ++c) {
    if (faces[c].empty()) {
      made.none[c / 32] |= 1U << (c % 32);
      continue;
    }
    const auto kept = open[c] ? faces[c] : front.among(faces[c]);
    const bool few = kept.size() <= WidePlanes::kPlanes && !open[c];
    if (const auto bend = few ? bend_of({mesh, planes}, kept) : std::nullopt) {
      set_planes(planes, kept, *bend, made.cells[c], made);
    } else {
      add_blocks(all, kept, made.cells[c], made);
    }
  }
  return made;
}

}  // namespace impinge
