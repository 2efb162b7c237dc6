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
#include <utility>
#include <vector>

#include "culling/moved_caps.hpp"

namespace impinge {

class CulledScan {
 public:
  // Meshes in their centre frames. Vertices of no face belong to no surface.
  CulledScan(ScannedSurface scanned, const TriangleMesh& vertices_of, const TriangleMesh& asked,
             double margin = 0.0);

  ScannedSurface scanned() const { return scanned_; }  // whose vertices are scanned
  const CapTree& tree() const { return tree_; }        // of these vertices
  const CapLimits& limits() const { return limits_; }  // of the other surface
  // Item of the tree's order: a vertex of the mesh.
  std::uint32_t vertex(std::size_t item) const { return vertex_[item]; }
  // Where that vertex is in its mesh, mm.
  const Vec3& position(std::size_t item) const { return position_[item]; }
  std::size_t bytes() const;  // of tree, limits and positions

 private:
  ScannedSurface scanned_;
  CapTree tree_;
  CapLimits limits_;
  std::vector<std::uint32_t> vertex_;
  std::vector<Vec3> position_;
};

// Of the pending nodes of a search the nearest is opened first.
class PendingNodes {
 public:
  bool empty() const { return count_ == 0; }       // nothing is left to be opened
  CapNode pop() { return nodes_[--count_].node; }  // the last one, which is taken out
  std::size_t size() const { return count_; }      // number of them
  // Kept if its gap is 0 or less; without a branch, which could not be foreseen.
  void push(float gap, CapNode node) {
    nodes_[count_] = {gap, node};
    count_ += gap > 0.0F ? 0U : 1U;
  }
  // Puts the nearest of those from `first` on last.
  void nearest_last(std::size_t first) {
    if (count_ < first + 2) return;
    std::size_t nearest = first;
    for (std::size_t i = first + 1; i < count_; ++i)
      nearest = nodes_[i].gap < nodes_[nearest].gap ? i : nearest;
    std::swap(nodes_[nearest], nodes_[count_ - 1]);
  }

 private:
  struct Pending {
    float gap;
    CapNode node;
  };
  std::array<Pending, CapTree::kMostPending + 1> nodes_;
  std::size_t count_ = 0;
};

// A search for a vertex that touches. asked(vertex, x), x being where the pose has it, says whether it does:
// a gap of 0 or less.
template <class Asked>
class TouchSearch {
 public:
  // Keeps references to scan and move.
  TouchSearch(const CulledScan& scan, const CapMove& move, Asked asked)
      : scan_(scan), move_(move), asked_(asked) {}

  // Among all vertices: one that touches, if one does.
  std::optional<std::uint32_t> run() {
    const std::size_t roots = std::min(CapTree::kRoots, scan_.tree().blocks().size());
    for (std::uint32_t block = 0; block < roots; ++block) test(block);
    pending_.nearest_last(0);
    while (!pending_.empty()) {
      const CapNode node = pending_.pop();
      const CapBlock& block = scan_.tree().blocks()[node.block];
      if (!block.leaf(node.lane)) {
        const std::size_t first = pending_.size();
        test(block.first[node.lane]);
        pending_.nearest_last(first);
      } else if (const auto vertex = ask(block.first[node.lane], block.items[node.lane])) {
        return vertex;
      }
    }
    return std::nullopt;
  }

 private:
  void test(std::uint32_t at) {
    const CapBlock& block = scan_.tree().blocks()[at];
    const GapBounds bounds = gap_bounds(block, move_, scan_.limits(), 0.0F);
    for (std::uint32_t lane = 0; lane < block.nodes; ++lane) pending_.push(bounds.gap[lane], {at, lane});
  }

  std::optional<std::uint32_t> ask(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t item = first; item < first + count; ++item) {
      const Vec3 x = move_.place(scan_.position(item));
      if (vertex_bound(x, move_, scan_.limits()) > 0.0) continue;
      if (asked_(scan_.vertex(item), x)) return scan_.vertex(item);
    }
    return std::nullopt;
  }

  const CulledScan& scan_;
  const CapMove& move_;
  Asked asked_;
  PendingNodes pending_;
};

}  // namespace impinge
