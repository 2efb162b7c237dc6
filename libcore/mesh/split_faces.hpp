// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts some faces of a mesh into smaller ones, without leaving a corner inside the side of another face. The
// surface stays the same set of points, and stays closed if it was.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// A mesh some of whose faces were cut.
struct SplitFaces {
  TriangleMesh mesh;                // old vertices keep their numbers; new ones are middles of sides
  std::vector<std::size_t> parent;  // for each face the old face that it is a part of
};

/// Cuts the marked faces into four, by the middles of their sides, and faces that share such a side into up
/// to four. Each face is halved at its longest side first (Rivara 1984, "Algorithms for refining triangular
/// grids ..."), so that no angle ever falls below half of the smallest. `marked` has one value for each face.
/// A face that is not cut stays as it is.
SplitFaces split_faces(const TriangleMesh& mesh, const std::vector<bool>& marked);

}  // namespace impinge
