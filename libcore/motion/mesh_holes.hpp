// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface is missing, as the centre sees it.
#pragma once

#include "contact/cap_tree.hpp"
#include "motion/seen_surface.hpp"

namespace impinge {

/// Caps of directions that together hold every direction that meets no face; none for a surface all round.
/// Made of cells on the six faces of a cube, each halved until the mesh covers it without a hole
/// (SeenSurface::covers(), from any face along its middle), no face is near, or it is 1.4 degrees wide: then
/// it counts as missing.
CapTree mesh_holes(const SeenSurface& surface);

}  // namespace impinge
