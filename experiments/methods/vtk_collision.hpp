// SPDX-License-Identifier: GPL-3.0-or-later
// Method vtk_collide: trees of oriented boxes on both surfaces, by VTK's vtkCollisionDetectionFilter.
#pragma once

#include <memory>

#include "mesh/triangle_mesh.hpp"
#include "methods/touch_method.hpp"

namespace impinge::lab {

// Meshes in their centre frames, mm; both are copied. Asks for one contact and stops there. The trees are
// built with the first pose that is asked for.
std::unique_ptr<TouchMethod> make_vtk_collision(const TriangleMesh& ball, const TriangleMesh& socket);

}  // namespace impinge::lab
