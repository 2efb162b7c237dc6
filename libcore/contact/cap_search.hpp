// SPDX-License-Identifier: GPL-3.0-or-later
// How near to the centre, or far from it, the faces come that a cap of directions meets.
#pragma once

#include <vector>

#include "contact/cap_tree.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge {

class CapSearch {
 public:
  /// mesh in the centre frame. Faces whose plane holds the centre are left out.
  CapSearch(const TriangleMesh& mesh, Layer layer);

  /// The least radius of all faces that meet the cap (the largest for Layer::farthest), mm, rounded away from
  /// the radii; of none infinite (-infinite). Nodes of `resolution` radians are taken whole, so that faces a
  /// little beyond the cap may count.
  float limit(const DirectionCap& cap, double resolution);

 private:
  void visit(std::uint32_t at);
  bool look_at(const CapNode& node);
  void include(const CapItem& item);

  std::vector<CapItem> items_;
  CapTree tree_;
  bool nearest_;
  DirectionCap cap_;
  double resolution_ = 0.0;
  float limit_ = 0.0F;
  CapNode decisive_{0, 0};  // that gave a limit last
};

}  // namespace impinge
