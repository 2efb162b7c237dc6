// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/simd/cell_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>

#include "gap/simd/hit_cells.hpp"
#include "sphere/cube_faces.hpp"
#include "sphere/infinity.hpp"
#include "table/surface_plane.hpp"

namespace impinge {
namespace {

constexpr double kMostDoubt = 1e-9;  // of a plane that counts, see surface_plane.hpp
// Of the largest number of a cell. Rounding makes q . P off by kMostDoubt (|P| / R + q . P) / 2, R the
// farthest corner of a face that has a number of 1 / R or more somewhere in the cell.
constexpr double kRoundings = 2.0 * kMostDoubt;
constexpr double kFew = 2e-3;  // of a number: planes that differ by less need no search for hidden faces

using Corners = std::array<Vec3, 4>;
using Numbers = std::array<double, 4>;  // at the corners of a cell, 1 / mm

// A face that a cell may meet.
struct CellFace {
  std::uint32_t face = 0;
  Numbers number{};
  bool sheet = false;  // of those that cover the cell
};

// q of each face; zero where it is not sure.
std::vector<Vec3> sure_planes(const TriangleMesh& mesh) {
  std::vector<Vec3> planes;
  planes.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    const FacePlane& plane = cone.plane();
    double farthest = 0.0;
    for (const Vec3& v : cone.corners()) farthest = std::max(farthest, v.norm());
    const bool sure = !cone.edge_on() && kPlaneRoundings * plane.size * farthest <= kMostDoubt * plane.offset;
    planes.push_back(sure ? Vec3(plane.normal / plane.offset) : Vec3::Zero());
  }
  return planes;
}

bool share_an_edge(const Face& a, const Face& b) {
  const auto common = std::ranges::count_if(a, [&](VertexIndex v) { return std::ranges::count(b, v) > 0; });
  return common >= 2;
}

class CellBoundSearch {
 public:
  CellBoundSearch(const TriangleMesh& mesh, Layer layer, double margin)
      : mesh_(mesh),
        planes_(sure_planes(mesh)),
        sign_(layer == Layer::nearest ? 1.0 : -1.0),
        slack_(2.0 * kRoundings + 8.0 * margin) {}

  CellBound bound(std::span<const std::uint32_t> faces, const Corners& corner, const Numbers& kept) {
    met_.clear();
    for (const std::uint32_t f : faces) {
      const Vec3& q = planes_[f];
      if (q.isZero(0.0)) return {kInfinity, 1.0};
      met_.push_back({f, {q.dot(corner[0]), q.dot(corner[1]), q.dot(corner[2]), q.dot(corner[3])}});
    }
    const auto [least, most] = std::ranges::minmax(kept);
    double off = largest_difference(kept);
    if (off > kFew * least && met_.size() > 1) {
      drop_hidden(kept);
      off = largest_difference(kept);
    }
    off += kRoundings * (most + off);
    if (!(off < least)) return {kInfinity, 1.0};
    double farthest = 0.0;
    for (const Vec3& c : corner) farthest = std::max(farthest, c.norm());
    return {farthest * off / (least * (least - off)) * (1.0 + kRoundings), (most + off) / (least - off)};
  }

 private:
  double largest_difference(const Numbers& kept) const {
    double largest = 0.0;
    for (const CellFace& one : met_)
      for (std::size_t k = 0; k < 4; ++k) largest = std::max(largest, std::abs(one.number[k] - kept[k]));
    return largest;
  }

  // Marks the faces that are joined by edges to the one that is met at the first corner.
  void find_sheet(const Numbers& kept) {
    const auto off = [&](const CellFace& one) { return std::abs(one.number[0] - kept[0]); };
    open_.assign(1, static_cast<std::size_t>(std::ranges::min_element(met_, {}, off) - met_.begin()));
    met_[open_[0]].sheet = true;
    while (!open_.empty()) {
      const Face& here = mesh_.faces[met_[open_.back()].face];
      open_.pop_back();
      for (std::size_t k = 0; k < met_.size(); ++k) {
        if (met_[k].sheet || !share_an_edge(here, mesh_.faces[met_[k].face])) continue;
        met_[k].sheet = true;
        open_.push_back(k);
      }
    }
  }

  void drop_hidden(const Numbers& kept) {
    find_sheet(kept);
    Numbers sheet;
    sheet.fill(kInfinity);
    double size = 0.0;
    for (const CellFace& one : met_) {
      for (std::size_t k = 0; k < 4; ++k) {
        size = std::max(size, std::abs(one.number[k]));
        if (one.sheet) sheet[k] = std::min(sheet[k], sign_ * one.number[k]);
      }
    }
    std::erase_if(met_, [&](const CellFace& one) {
      bool behind = !one.sheet;
      for (std::size_t k = 0; k < 4; ++k) behind = behind && sign_ * one.number[k] < sheet[k] - slack_ * size;
      return behind;
    });
  }

  const TriangleMesh& mesh_;
  std::vector<Vec3> planes_;
  double sign_;  // times a number: the largest counts
  // Share of the largest number. Directions that count may be beyond the cell by the margin on two sides,
  // which changes the difference of two planes' numbers, at most 4 times the largest, by 2 margins of it.
  double slack_;
  std::vector<CellFace> met_;
  std::vector<std::size_t> open_;
};

}  // namespace

std::vector<CellBound> cell_bounds(const TriangleMesh& mesh, Layer layer,
                                   const InverseDepthTable<CubeGnomonic>& table) {
  const std::size_t n = table.scheme().divisions();
  const std::size_t lines = n + 1;
  std::vector<std::uint32_t> all(mesh.faces.size());
  std::iota(all.begin(), all.end(), 0U);
  const CellGrid grid = float_grid(n);
  const Lists faces = faces_of_cells(mesh, all, grid);
  const auto at = [n](std::size_t line) {
    return -1.0 + 2.0 * static_cast<double>(line) / static_cast<double>(n);
  };
  CellBoundSearch search(mesh, layer, grid.margin);
  std::vector<CellBound> bounds(table.scheme().size());
  for (std::size_t e = 0; e + lines + 1 < bounds.size(); ++e) {
    const std::size_t i = e % lines;
    const std::size_t j = e / lines % lines;
    if (i == n || j == n) continue;
    const auto& v = table.values();
    const Numbers kept{v[e], v[e + 1], v[e + lines], v[e + lines + 1]};
    if (std::ranges::any_of(kept, [](double number) { return std::isnan(number); })) continue;
    const std::size_t face = e / (lines * lines);
    const Corners corner{cube_point(face, at(i), at(j)), cube_point(face, at(i + 1), at(j)),
                         cube_point(face, at(i), at(j + 1)), cube_point(face, at(i + 1), at(j + 1))};
    bounds[e] = search.bound(faces[e], corner, kept);
  }
  return bounds;
}

}  // namespace impinge
