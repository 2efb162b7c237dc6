// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/vtk_collision.hpp"

#include <vtkCollisionDetectionFilter.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "imaging/vtk_surface.hpp"

namespace impinge::lab {
namespace {

class VtkCollision final : public TouchMethod {
 public:
  VtkCollision(const TriangleMesh& ball, const TriangleMesh& socket) {
    to_vtk(ball, *ball_);
    to_vtk(socket, *socket_);
    filter_->SetInputData(0, ball_);
    filter_->SetInputData(1, socket_);
    filter_->SetMatrix(0, placed_);
    filter_->SetMatrix(1, fixed_);
    filter_->SetCollisionModeToFirstContact();
    filter_->GenerateScalarsOff();
  }

  std::string_view name() const override { return "vtk_collide"; }
  bool gives_distance() const override { return false; }

  bool touches(const Pose& pose) override {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) placed_->SetElement(row, column, pose.rotation(row, column));
      placed_->SetElement(row, 3, pose.translation(row));
    }
    filter_->Modified();  // also where the pose is that of before
    filter_->Update();
    return filter_->GetNumberOfContacts() > 0;
  }

 private:
  vtkNew<vtkPolyData> ball_;
  vtkNew<vtkPolyData> socket_;
  vtkNew<vtkMatrix4x4> placed_;
  vtkNew<vtkMatrix4x4> fixed_;
  vtkNew<vtkCollisionDetectionFilter> filter_;
};

}  // namespace

std::unique_ptr<TouchMethod> make_vtk_collision(const TriangleMesh& ball, const TriangleMesh& socket) {
  return std::make_unique<VtkCollision>(ball, socket);
}

}  // namespace impinge::lab
