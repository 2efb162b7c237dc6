// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_certified/range_table.hpp"

#include <algorithm>

#include "mesh/edges.hpp"
#include "mesh/jump_edges.hpp"

namespace impinge::lab {
namespace {

Edge sorted(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

std::vector<std::array<bool, 3>> jump_sides(const TriangleMesh& mesh) {
  std::vector<Edge> jumps;
  for (const JumpEdge& edge : jump_edges(mesh)) jumps.push_back(sorted(edge.from, edge.to));
  std::ranges::sort(jumps);
  std::vector<std::array<bool, 3>> sides(mesh.faces.size());
  for (std::size_t f = 0; f < sides.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = ends(mesh, {f, k});
      sides[f][k] = std::ranges::binary_search(jumps, sorted(a, b));
    }
  }
  return sides;
}

}  // namespace impinge::lab
