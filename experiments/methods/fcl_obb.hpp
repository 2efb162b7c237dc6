// SPDX-License-Identifier: GPL-3.0-or-later
// Method fcl_obb: trees of oriented boxes on both surfaces, by FCL. The thesis compares with RAPID
// (Gottschalk, Lin and Manocha 1996). RAPID itself is not free software: its licence allows no commercial
// use. FCL is its kept descendant, from the same group, with the same tree.
#pragma once

#include <memory>

#include "mesh/triangle_mesh.hpp"
#include "methods/touch_method.hpp"

namespace impinge::lab {

// Meshes in their centre frames, mm; both are copied. Asks for one contact, without its depth, and stops
// there.
std::unique_ptr<TouchMethod> make_fcl_obb(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
