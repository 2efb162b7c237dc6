// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the limit of a cap of directions: how near to the centre, or how far from it, the faces in it come.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/cap_tree.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge {

/// Nodes of a block that may change the limit of a cap, one bit for each.
struct FoundNodes {
  std::uint32_t whole = 0;  // nodes that lie within the cap, and narrow ones that meet it
  std::uint32_t part = 0;   // other nodes that meet it
};

/// A cap in floats, for the comparison with nodes. The kNodeSlack of nodes covers the rounding.
struct ComparedCap {
  float x, y, z;     // axis
  float radius;      // radians
  float resolution;  // radians
  float sign;        // -1 for the nearest layer, else 1: of radii times this the largest counts
  float known;       // sign times the limit so far
};

class CapSearch {
 public:
  /// `mesh` is in the centre frame. Faces whose plane holds the centre are left out.
  CapSearch(const TriangleMesh& mesh, Layer layer);

  /// The least radius of all faces that meet the cap (the largest for Layer::farthest), mm, rounded outwards;
  /// none() without a face. Nodes of `resolution` radians are taken whole, so that faces a little beyond the
  /// cap may count. `known`, the limit of a cap within this one, or none(), saves time.
  float limit(const DirectionCap& cap, double resolution, float known);
  /// The limit if no face is met.
  float none() const { return nearest_ ? HUGE_VALF : -HUGE_VALF; }

 private:
  const CapLanes& limits_of(const CapBlock& block) const { return nearest_ ? block.low : block.high; }
  bool decided(float of_node) const { return nearest_ ? of_node >= limit_ : of_node <= limit_; }
  FoundNodes look_at(std::uint32_t block);
  void take(const CapNode& node);
  void visit(std::uint32_t at);
  void include(const CapItem& item);

  std::vector<CapItem> items_;
  CapTree tree_;
  bool nearest_;
  DirectionCap cap_;
  ComparedCap compared_{};
  float limit_ = 0.0F;
  CapNode decisive_{0, 0};  // the node that gave the last limit
};

}  // namespace impinge
