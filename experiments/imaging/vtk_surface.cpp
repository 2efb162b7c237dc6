// SPDX-License-Identifier: GPL-3.0-or-later
#include "imaging/vtk_surface.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace impinge {

void to_vtk(const TriangleMesh& mesh, vtkPolyData& surface) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& v : mesh.vertices) points->InsertNextPoint(v.data());
  vtkNew<vtkCellArray> cells;
  for (const Face& face : mesh.faces) cells->InsertNextCell({face[0], face[1], face[2]});
  surface.SetPoints(points);
  surface.SetPolys(cells);
}

}  // namespace impinge
