// SPDX-License-Identifier: GPL-3.0-or-later
// Methods vtk_first_hit and vtk_closest: first intersection with a ray from the centre, and distance of a
// point, by VTK's vtkStaticCellLocator, which sorts triangles into buckets. Of VTK's locators it is the
// fastest here: vtkModifiedBSPTree, vtkCellTreeLocator and vtkOBBTree take 5 to 300 times as long for a ray,
// vtkImplicitPolyDataDistance as long for a point.
#pragma once

#include <memory>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// mesh in the centre frame; its triangles are copied, in double. Bytes are those of the heap, see
// heap_use.hpp.
std::unique_ptr<RadiusMethod> make_vtk_first_hit(const TriangleMesh& mesh);
// Distances from the nearest point of the surface.
std::unique_ptr<RadiusMethod> make_vtk_closest(const TriangleMesh& mesh);

}  // namespace impinge::lab
