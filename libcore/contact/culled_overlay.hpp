// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether the surfaces of ball and socket impinge, edges included, without testing most faces. In
// every pose the answer is the same as by SurfaceOverlay::impinged() (gap/overlay.hpp): Theorem 8 (caps).
//
// Each face is compared exactly with the faces that share a direction with it, which a tree of caps finds.
// Where many poses are asked about, most faces are left out: the bounds of contact/gap_bounds.hpp hold for
// every point of the faces of a cap, also of one that the pose makes edge-on. If they show the cap to be
// clear, none of its faces reaches another.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/culled_joint.hpp"
#include "contact/gap_bounds.hpp"

namespace impinge {

class CulledOverlay {
 public:
  /// Takes the meshes in their centre frames, mm; they must outlive this. O(faces).
  explicit CulledOverlay(const BallSocketPair& joint);
  explicit CulledOverlay(const BallSocketPair&&) = delete;

  /// Is the pose impinged? Exact. Looks at every face, on two threads: for a few poses.
  bool impinged(const Pose& pose) const;
  /// The same from the limits of a joint of the same meshes, which leave out most faces: for many poses.
  bool impinged(const Pose& pose, const CulledJoint& limits) const;

  std::size_t bytes() const;  // of memory, without the meshes

 private:
  /// The faces of a surface that are not edge-on, in the order of their tree.
  struct Faces {
    CapTree tree{std::span<const CapItem>()};
    std::vector<Face> faces;
    std::vector<int> sides;  // orientations
  };
  static Faces faces_of(const TriangleMesh& mesh);
  bool reaches_any(std::size_t scan, const CapMove& move, const Face& face) const;
  /// The surface whose faces a scan moves, and the surface that it does not move.
  const TriangleMesh& moved(std::size_t scan) const { return scan == 0 ? joint_.ball : joint_.socket; }
  const TriangleMesh& at_rest(std::size_t scan) const { return moved(1 - scan); }

  const BallSocketPair& joint_;
  std::array<Faces, 2> surfaces_;  // ball and socket
};

}  // namespace impinge
