// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface is missing, as the centre sees it.
#pragma once

#include "contact/cap_tree.hpp"
#include "motion/seen_surface.hpp"

namespace impinge {

/// Caps of directions that together hold every direction that meets no face; none for a surface all round.
/// Cells of the six faces of a cube, halved until faces cover one without a hole (SeenSurface::covers(), of
/// any face along its middle), none is near, or a cell is 1.4 degrees wide, which is then taken for missing.
CapTree mesh_holes(const SeenSurface& surface);

}  // namespace impinge
