// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/face_runs.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include <Eigen/Geometry>

#include "mesh/collinear.hpp"
#include "mesh/lengths.hpp"

namespace impinge {
namespace {

constexpr std::size_t kWidth = FaceRuns::kWidth;

// A face and its middle, for sorting only.
struct RunItem {
  std::array<float, 3> middle;  // twice the middle of its box
  std::uint32_t face;
};

int longest_extent(std::span<const RunItem> items) {
  std::array<float, 3> low = items.front().middle;
  std::array<float, 3> high = low;
  for (const RunItem& item : items) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], item.middle[k]);
      high[k] = std::max(high[k], item.middle[k]);
    }
  }
  const std::array extent{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  return static_cast<int>(std::ranges::max_element(extent) - extent.begin());
}

// Sorts items into runs of so many items, and these into shorter runs.
void sort_into_runs(std::span<RunItem> items, std::size_t run) {
  if (items.size() <= kWidth) return;  // a block, in whatever order
  if (items.size() <= run) return sort_into_runs(items, run / kWidth);
  const auto axis = static_cast<std::size_t>(longest_extent(items));
  const std::size_t half = ((items.size() + run - 1) / run) / 2 * run;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [axis](const RunItem& a, const RunItem& b) { return a.middle[axis] < b.middle[axis]; });
  sort_into_runs(items.first(half), run);
  sort_into_runs(items.subspan(half), run);
}

// Asks collinear() only if the corners are not plainly apart from a line: 8 roundings at most.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double doubt = 0x1p-48 * ab.lpNorm<1>() * ac.lpNorm<1>();
  return ab.cross(ac).lpNorm<Eigen::Infinity>() > doubt + 1e-290 || !collinear(a, b, c);
}

std::vector<RunItem> items_with_area(const TriangleMesh& mesh) {
  std::vector<RunItem> items;
  items.reserve(mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto [a, b, c] = corners_of(mesh, mesh.faces[i]);
    if (!has_area(a, b, c)) continue;
    const Vec3 middle = a.cwiseMin(b).cwiseMin(c) + a.cwiseMax(b).cwiseMax(c);
    items.push_back(
        {{static_cast<float>(middle.x()), static_cast<float>(middle.y()), static_cast<float>(middle.z())},
         static_cast<std::uint32_t>(i)});
  }
  return items;
}

}  // namespace

FaceRuns::FaceRuns(const TriangleMesh& mesh) {
  require_float_lengths(mesh);
  std::vector<RunItem> items = items_with_area(mesh);
  std::size_t longest = 1;
  while (longest * kWidth < items.size()) longest *= kWidth;
  sort_into_runs(items, longest);
  constexpr VertexIndex kNone = std::numeric_limits<VertexIndex>::max();
  std::vector<VertexIndex> place(mesh.vertices.size(), kNone);
  faces.reserve(items.size());
  for (const RunItem& item : items) {
    Face face = mesh.faces[item.face];
    for (VertexIndex& v : face) {
      if (place[v] == kNone) {
        place[v] = static_cast<VertexIndex>(vertices.size());
        vertices.push_back(mesh.vertices[v]);
      }
      v = place[v];
    }
    faces.push_back(face);
  }
  for (std::size_t runs = faces.size(); runs > 1 || (runs == 1 && first.empty());) {
    runs = (runs + kWidth - 1) / kWidth;
    first.push_back(blocks);
    blocks += runs;
  }
}

}  // namespace impinge
