// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a mesh in an order that is a tree without pointers: eight neighbours make a run, eight such
// runs a longer one, and so on, each close together in space.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Of the runs of level k, each of 8^k faces (the last one may be shorter), eight neighbours are a block; a
/// run of level k + 1 is a block of level k. Split by halves along the longest extent of the faces' middles:
/// O(faces log(faces)).
struct FaceRuns {
  static constexpr std::size_t kWidth = 8;  // runs of a block

  explicit FaceRuns(const TriangleMesh& mesh);  // without faces that have no area

  std::vector<Vec3> vertices;      // mm, those of the faces
  std::vector<Face> faces;         // in the order of the runs
  std::vector<std::size_t> first;  // block of each level, in one list of all; the last level has one block
  std::size_t blocks = 0;          // of all levels
};

}  // namespace impinge
