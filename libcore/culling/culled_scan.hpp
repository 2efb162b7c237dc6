// SPDX-License-Identifier: GPL-3.0-or-later
// One scan, in which whole caps of vertices are decided at once: does some vertex touch the other surface,
// and which has the smallest gap? What is left over is asked vertex by vertex, of whoever is given; the
// answer is that of asking all vertices.
//
// Whoever is asked must keep to the limits: its radii are those of the mesh, or means of radii within the
// margin of the direction (see culling/cap_limits.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "culling/moved_caps.hpp"

namespace impinge {

class CulledScan {
 public:
  // Meshes in their centre frames. Vertices of no face belong to no surface.
  CulledScan(ScannedSurface scanned, const TriangleMesh& vertices_of, const TriangleMesh& asked,
             double margin = 0.0);

  ScannedSurface scanned() const { return scanned_; }
  const CapTree& tree() const { return tree_; }
  const CapLimits& limits() const { return limits_; }
  // Item of the tree's order: a vertex of the mesh.
  std::uint32_t vertex(std::size_t item) const { return vertex_[item]; }
  const Vec3& position(std::size_t item) const { return position_[item]; }
  std::size_t bytes() const;

 private:
  ScannedSurface scanned_;
  CapTree tree_;
  CapLimits limits_;
  std::vector<std::uint32_t> vertex_;
  std::vector<Vec3> position_;
};

// The first vertex found that touches: hit(vertex, x), x being where the pose has it, says whether it does,
// as a gap of 0 or less. cleared(node, bound) is told of each node none of whose vertices does, open(node) of
// each leaf that was asked and did not.
template <class Hit, class Cleared, class Open>
std::optional<std::uint32_t> find_touching(const CulledScan& scan, const CapMove& move, std::size_t from,
                                           Hit&& hit, Cleared&& cleared, Open&& open) {
  struct Pending {
    double gap;
    std::uint32_t node;
  };
  std::array<Pending, CapTree::kMostPending> pending;
  std::size_t count = 0;
  const auto& nodes = scan.tree().nodes();
  const auto test = [&](std::size_t n) {
    const GapBound bound = gap_bound(nodes[n], move, scan.limits());
    if (bound.gap > 0.0) {
      cleared(n, bound);
      return;
    }
    pending[count++] = {bound.gap, static_cast<std::uint32_t>(n)};
  };
  if (nodes.empty()) return std::nullopt;
  test(from);
  while (count > 0) {
    const std::uint32_t n = pending[--count].node;
    const CapNode& node = nodes[n];
    if (node.leaf != 0) {
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        const Vec3 x = move.place(scan.position(k));
        if (vertex_bound(x, move, scan.limits()) > 0.0) continue;
        if (hit(scan.vertex(k), x)) return scan.vertex(k);
      }
      open(n);
      continue;
    }
    const std::size_t first = count;
    for (std::uint32_t k = 0; k < node.count; ++k) test(node.first + k);
    // The nearest last, to be opened first.
    std::sort(pending.begin() + static_cast<std::ptrdiff_t>(first),
              pending.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Pending& a, const Pending& b) { return a.gap > b.gap; });
  }
  return std::nullopt;
}

}  // namespace impinge
