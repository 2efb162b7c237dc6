// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest distance between two surfaces in a pose, by FCL's trees of boxes with a rectangle swept by a
// sphere inside.
#pragma once

#include <memory>

#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

class FclDistance {
 public:
  // Meshes in their centre frames, mm; both are copied.
  FclDistance(const TriangleMesh& ball, const TriangleMesh& socket);
  ~FclDistance();

  // mm, 0 where they touch, to the last digits (no tolerance is given away).
  double distance(const Pose& pose) const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace impinge::lab
