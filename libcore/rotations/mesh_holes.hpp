// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface is missing, as the centre sees it.
#pragma once

#include <vector>

#include "contact/cap_tree.hpp"
#include "rotations/seen_surface.hpp"

namespace impinge {

/// Directions that meet no face.
struct MeshHoles {
  CapTree tree;                     // of `caps`; empty for a surface all round
  std::vector<DirectionCap> caps;   // these together hold all such directions, in the order of the tree
  std::vector<DirectionCap> empty;  // those of them near which no face has a direction
};

/// Made of cells on the six faces of a cube, each halved until the mesh covers it without a hole
/// (SeenSurface::covers(), from any face along its middle), no face is near, or it is 0.35 degrees wide: then
/// it counts as missing.
MeshHoles mesh_holes(const SeenSurface& surface);

}  // namespace impinge
