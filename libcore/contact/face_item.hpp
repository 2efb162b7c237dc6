// SPDX-License-Identifier: GPL-3.0-or-later
// A face as an item of a tree of caps.
#pragma once

#include <optional>

#include "contact/cap_tree.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Its directions and radii as the centre of the mesh sees it, mm: any direction for a face of a quarter turn
/// and more, any radius below its largest for one that is almost edge-on. None for one whose plane holds the
/// centre, which covers no direction.
std::optional<CapItem> face_item(const TriangleMesh& mesh, const Face& face);

}  // namespace impinge
