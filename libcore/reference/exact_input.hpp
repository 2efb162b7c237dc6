// SPDX-License-Identifier: GPL-3.0-or-later
// Refuses input that the exact references cannot take, with a line that names it and says what to do.
#pragma once

#include <span>
#include <string_view>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// Throws std::invalid_argument for a mesh without faces, a face that names a vertex that does not exist, and
/// a vertex of a face that is not finite.
void require_exact_input(const TriangleMesh& mesh);

/// Throws std::invalid_argument for a component that is not finite. `what` names a value in the
/// message, such as "direction".
void require_finite(std::span<const Vec3> values, std::string_view what);

}  // namespace impinge
