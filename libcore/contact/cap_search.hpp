// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of a cap of directions: how near to the centre, or far from it, the faces that meet it come.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/cap_tree.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge {

/// Nodes of a block that may change the limit of a cap, a bit each.
struct FoundNodes {
  std::uint32_t whole = 0;  // all that they hold is in the cap, or they are narrow and meet it
  std::uint32_t part = 0;   // the rest of those that meet it
};

/// A cap as nodes are compared with it, in floats: kNodeSlack, which caps have, covers the rounding.
struct ComparedCap {
  float x, y, z;     // axis
  float radius;      // radians
  float resolution;  // the same
  float sign;        // -1 for the nearest: of what is multiplied by it the largest counts
  float known;       // sign times the limit so far
};

class CapSearch {
 public:
  /// mesh in the centre frame. Faces whose plane holds the centre are left out.
  CapSearch(const TriangleMesh& mesh, Layer layer);

  /// The least radius of all faces that meet the cap (the largest for Layer::farthest), mm, rounded away from
  /// the radii; of none infinite (-infinite). Nodes of `resolution` radians are taken whole, so that faces a
  /// little beyond the cap may count. `known`, the limit of a cap within this one or none(), saves time.
  float limit(const DirectionCap& cap, double resolution, float known);
  /// The limit where no face is met.
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
  CapNode decisive_{0, 0};  // that gave a limit last
};

}  // namespace impinge
