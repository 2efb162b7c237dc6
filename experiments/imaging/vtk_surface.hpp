// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh as VTK wants it.
#pragma once

#include "mesh/triangle_mesh.hpp"

class vtkPolyData;

namespace impinge {

/// Points in double (mm, the frame of the mesh) and triangles, in the order of the mesh; they replace what
/// `surface` held.
void to_vtk(const TriangleMesh& mesh, vtkPolyData& surface);

}  // namespace impinge
