// SPDX-License-Identifier: GPL-3.0-or-later
// Where the centre sees no face of a surface.
#pragma once

#include <vector>

#include "contact/cap_tree.hpp"
#include "rotations/seen_surface.hpp"

namespace impinge {

/// Directions that meet no face.
struct MeshHoles {
  CapTree tree;                     // of `caps`; empty for a surface all round
  std::vector<DirectionCap> caps;   // together they hold all such directions; in the order of the tree
  std::vector<DirectionCap> empty;  // caps of these, or about their axes, in which no direction meets a face
};

/// The holes of a surface, as caps round cells on the six faces of a cube. A cell is halved until the surface
/// covers it (SeenSurface::covers()), no face is near, or it is 0.35 degrees wide and a direction in it is
/// known to have no face, or 0.09 degrees wide: then it counts as missing.
MeshHoles mesh_holes(const SeenSurface& surface);

}  // namespace impinge
