// SPDX-License-Identifier: GPL-3.0-or-later
// @can     steps
// @links   gap peer::vtk
//
// Method vtk_collide: VTK's collision filter, with trees of oriented boxes on both surfaces, as a user of VTK
// or 3D Slicer would call it; the first contact ends the search. The filter is made to show contacts, so each
// answer also moves a copy of the surface, which is part of its time.

#include <memory>

#include <vtkCellArray.h>
#include <vtkCollisionDetectionFilter.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

vtkNew<vtkPolyData> surface_of(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& x : mesh.vertices) points->InsertNextPoint(x.data());
  vtkNew<vtkCellArray> cells;
  for (const Face& face : mesh.faces) cells->InsertNextCell({face[0], face[1], face[2]});
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

class Filter {
 public:
  explicit Filter(const BallSocketPair& pair) {
    filter_->SetInputData(0, surface_of(pair.ball));
    filter_->SetInputData(1, surface_of(pair.socket));
    filter_->SetMatrix(0, ball_);
    filter_->SetMatrix(1, socket_);
    filter_->SetCollisionModeToFirstContact();
    filter_->SetBoxTolerance(0.0);
    filter_->SetCellTolerance(0.0);
    filter_->Update();  // makes its trees
  }

  bool touches(const Pose& pose) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) ball_->SetElement(row, column, pose.rotation(row, column));
      ball_->SetElement(row, 3, pose.translation(row));
    }
    filter_->Update();
    return filter_->GetNumberOfContacts() > 0;
  }

 private:
  vtkNew<vtkMatrix4x4> ball_;
  vtkNew<vtkMatrix4x4> socket_;
  vtkNew<vtkCollisionDetectionFilter> filter_;
};

Touch vtk_touch(const BallSocketPair& pair) {
  return [filter = std::make_shared<Filter>(pair)](const Pose& pose) { return filter->touches(pose); };
}

}  // namespace

Method vtk_method() {
  Method method;
  method.steps = [](const BallSocketPair& pair) {
    ContactCase one = touch_only("vtk_collide", "VTK", 1, pair, vtk_touch);
    one.few = true;
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
