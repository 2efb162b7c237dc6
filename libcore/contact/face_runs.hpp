// SPDX-License-Identifier: GPL-3.0-or-later
// Orders the faces of a mesh so that they form a tree without pointers: eight neighbours make a run, eight
// such runs a longer run, and so on, each close together in space.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A run of level k has 8^k faces (the last one may be shorter). Eight neighbouring runs are a block of level
/// k and make a run of level k + 1. Faces are split by halves along the longest extent of their middles, in
/// O(faces log(faces)).
struct FaceRuns {
  static constexpr std::size_t kWidth = 8;  // runs of a block

  /// Leaves out faces without area. Throws as require_float_lengths() (mesh/lengths.hpp).
  explicit FaceRuns(const TriangleMesh& mesh);

  std::vector<Vec3> vertices;      // mm, the vertices of the faces
  std::vector<Face> faces;         // in the order of the runs
  std::vector<std::size_t> first;  // number of the first block of each level; the last level has one block
  std::size_t blocks = 0;          // number of blocks of all levels
};

}  // namespace impinge
