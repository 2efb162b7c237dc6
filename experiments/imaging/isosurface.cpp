// SPDX-License-Identifier: GPL-3.0-or-later
#include "imaging/isosurface.hpp"

#include <algorithm>
#include <stdexcept>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkVersion.h>

#include "imaging/vtk_surface.hpp"

namespace impinge {
namespace {

TriangleMesh from_vtk(vtkPolyData& surface) {
  TriangleMesh mesh;
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
    const double* x = surface.GetPoint(i);
    mesh.vertices.emplace_back(x[0], x[1], x[2]);
  }
  vtkIdType count = 0;
  const vtkIdType* corner = nullptr;
  vtkCellArray* cells = surface.GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(count, corner) != 0;) {
    const Face face{static_cast<VertexIndex>(corner[0]), static_cast<VertexIndex>(corner[1]),
                    static_cast<VertexIndex>(corner[2])};
    const bool repeats = face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
    if (count == 3 && !repeats) mesh.faces.push_back(face);
  }
  return mesh;
}

}  // namespace

TriangleMesh isosurface(const VoxelImage& image, double level) {
  if (image.values.size() != image.size()) {
    throw std::invalid_argument("an image needs as many values as it has voxels");
  }
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(image.size()));
  std::ranges::copy(image.values, values->GetPointer(0));
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(static_cast<int>(image.count[0]), static_cast<int>(image.count[1]),
                      static_cast<int>(image.count[2]));
  grid->SetSpacing(image.spacing.x(), image.spacing.y(), image.spacing.z());
  grid->SetOrigin(image.origin.x(), image.origin.y(), image.origin.z());
  grid->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(grid);
  filter->SetValue(0, level);
  filter->ComputeNormalsOff();
  filter->ComputeScalarsOff();
  filter->Update();
  return from_vtk(*filter->GetOutput());
}

TriangleMesh decimate(const TriangleMesh& mesh, std::size_t faces) {
  if (mesh.faces.size() <= faces) return mesh;
  vtkNew<vtkPolyData> surface;
  to_vtk(mesh, *surface);
  vtkNew<vtkQuadricDecimation> filter;
  filter->SetInputData(surface);
  filter->SetTargetReduction(1.0 - static_cast<double>(faces) / static_cast<double>(mesh.faces.size()));
  filter->Update();
  return from_vtk(*filter->GetOutput());
}

std::string isosurface_library() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }

}  // namespace impinge
