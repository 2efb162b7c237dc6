// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether the surfaces of ball and socket impinge, edges included, without testing most faces. In
// every pose the answer is the same as by SurfaceOverlay::impinged() (gap/overlay.hpp): Theorem 8 (caps).
//
// A face is an item like a vertex: the bounds of contact/gap_bounds.hpp hold for every point of it, also if
// the pose makes it edge-on. A face whose cap is clear reaches no face. The others are compared exactly with
// the faces that share a direction with them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/culled_joint.hpp"
#include "contact/gap_bounds.hpp"

namespace impinge {

class CulledOverlay {
 public:
  /// The joint must outlive this. O(faces).
  explicit CulledOverlay(const CulledJoint& joint);
  explicit CulledOverlay(const CulledJoint&&) = delete;

  /// Is the pose impinged? Exact.
  bool impinged(const Pose& pose) const;

  std::size_t bytes() const;  // of memory, without the joint

 private:
  /// The faces of a surface that are not edge-on, in the order of their tree.
  struct Faces {
    CapTree tree;
    std::vector<Face> faces;
    std::vector<int> sides;  // orientations
  };
  static Faces faces_of(const TriangleMesh& mesh);
  bool reaches_any(std::size_t scan, const CapMove& move, const Face& face) const;
  /// The surface whose faces a scan moves, and the surface that it does not move.
  const TriangleMesh& moved(std::size_t scan) const;
  const TriangleMesh& at_rest(std::size_t scan) const { return moved(1 - scan); }

  const CulledJoint& joint_;
  std::array<Faces, 2> surfaces_;  // ball and socket
};

}  // namespace impinge
