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

// Of the pending nodes of a search the nearest is opened first.
class PendingNodes {
 public:
  struct Pending {
    float gap;
    CapNode node;
  };

  bool empty() const { return count_ == 0; }
  void push(const Pending& pending) { nodes_[count_++] = pending; }
  CapNode pop() { return nodes_[--count_].node; }
  std::size_t size() const { return count_; }
  // Puts the nearest of those from `first` on last.
  void nearest_last(std::size_t first) {
    if (count_ < first + 2) return;
    std::size_t nearest = first;
    for (std::size_t i = first + 1; i < count_; ++i)
      nearest = nodes_[i].gap < nodes_[nearest].gap ? i : nearest;
    std::swap(nodes_[nearest], nodes_[count_ - 1]);
  }

 private:
  std::array<Pending, CapTree::kMostPending> nodes_;
  std::size_t count_ = 0;
};

// A search for a vertex that touches. asked(vertex, x), x being where the pose has it, says whether it does:
// a gap of 0 or less. cleared(node, gap, spare) is told of each node none of whose vertices does;
// opened(node) of each leaf whose vertices were asked.
template <class Asked, class Cleared, class Opened>
class TouchSearch {
 public:
  TouchSearch(const CulledScan& scan, const CapMove& move, Asked asked, Cleared cleared, Opened opened)
      : scan_(scan), move_(move), asked_(asked), cleared_(cleared), opened_(opened) {}

  // Among all vertices.
  std::optional<std::uint32_t> run() {
    const std::size_t roots = std::min(CapTree::kRoots, scan_.tree().blocks().size());
    for (std::uint32_t block = 0; block < roots; ++block) test(block);
    pending_.nearest_last(0);
    return search();
  }

  // Among those of a node that is known not to be clear.
  std::optional<std::uint32_t> run(const CapNode& node) {
    pending_.push({0.0F, node});
    return search();
  }

 private:
  void test(std::uint32_t at) {
    const CapBlock& block = scan_.tree().blocks()[at];
    const GapBounds bounds = gap_bounds(block, move_, scan_.limits(), 0.0F);
    for (std::uint32_t lane = 0; lane < block.nodes; ++lane) {
      const auto k = static_cast<Eigen::Index>(lane);
      if (bounds.gap[k] > 0.0F) {
        cleared_(CapNode{at, lane}, bounds.gap[k], bounds.spare[k]);
      } else {
        pending_.push({bounds.gap[k], {at, lane}});
      }
    }
  }

  std::optional<std::uint32_t> search() {
    while (!pending_.empty()) {
      const CapNode node = pending_.pop();
      const CapBlock& block = scan_.tree().blocks()[node.block];
      if (!block.leaf(node.lane)) {
        const std::size_t first = pending_.size();
        test(block.first[node.lane]);
        pending_.nearest_last(first);
      } else if (const auto vertex = ask(block.first[node.lane], block.items[node.lane])) {
        return vertex;
      } else {
        opened_(node);
      }
    }
    return std::nullopt;
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
  Cleared cleared_;
  Opened opened_;
  PendingNodes pending_;
};

}  // namespace impinge
