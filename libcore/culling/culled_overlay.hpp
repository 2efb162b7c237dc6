// SPDX-License-Identifier: GPL-3.0-or-later
// Do the surfaces of ball and socket impinge, edges and all, without asking most faces? The answers are those
// of SurfaceOverlay::impinged() (detection/overlay.hpp), in every pose.
//
// A face is an item like a vertex: its directions are within its cap and its radii in its range, so that the
// bounds of culling/gap_bounds.hpp hold for every point of it. A face whose cap is clear shares no direction
// with a face that it reaches. The others are compared with those faces that
// share a direction with them, exactly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "culling/cap_move.hpp"
#include "culling/culled_joint.hpp"

namespace impinge {

class CulledOverlay {
 public:
  // The joint must outlive this. O(faces).
  explicit CulledOverlay(const CulledJoint& joint);

  // Is the pose impinged? Exact.
  bool impinged(const Pose& pose) const;

  std::size_t bytes() const;  // of trees and orientations

 private:
  bool reaches_any(std::size_t scan, const CapMove& move, const Face& face) const;
  // The surface whose faces a scan moves, and the other one.
  const TriangleMesh& moved(std::size_t scan) const;
  const TriangleMesh& at_rest(std::size_t scan) const { return moved(1 - scan); }

  const CulledJoint& joint_;
  std::array<CapTree, 2> trees_;           // of the faces of ball and socket
  std::array<std::vector<int>, 2> sides_;  // orientations of the faces, in the order of the trees
};

}  // namespace impinge
