// SPDX-License-Identifier: GPL-3.0-or-later
// @can     gaps contact
// @links   gap gap_queries heap_use imaging_vtk peer::vtk
//
// Methods vtk_first_hit and vtk_closest: first intersection with a ray from the centre, and distance of a
// point, by VTK's vtkStaticCellLocator, which sorts triangles into buckets. Of VTK's locators it is the
// fastest here: vtkModifiedBSPTree, vtkCellTreeLocator and vtkOBBTree take 5 to 300 times as long for a ray,
// vtkImplicitPolyDataDistance as long for a point. Method vtk_collide: trees of oriented boxes on both
// surfaces, by vtkCollisionDetectionFilter. It asks for one contact and stops there. The trees are built
// with the first pose that is asked for, which is part of building here.

#include <algorithm>
#include <cmath>
#include <memory>

#include <vtkCollisionDetectionFilter.h>
#include <vtkGenericCell.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include "imaging/vtk_surface.hpp"
#include "methods/contact.hpp"
#include "methods/gaps.hpp"
#include "methods/heap_use.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

// Triangles are copied, in double. Bytes are those of the heap.
struct LocatedSurface {
  explicit LocatedSurface(const TriangleMesh& mesh) : heap_before(heap_bytes()) {
    for (const Vec3& v : mesh.vertices) farthest = std::max(farthest, v.norm());
    to_vtk(mesh, *surface);
    locator->SetDataSet(surface);
    locator->BuildLocator();
    bytes = heap_bytes() - heap_before;
  }

  double first_hit(const Vec3& x) {
    const Vec3 centre = Vec3::Zero();
    const double length = 2.0 * farthest;
    const Vec3 end = length / x.norm() * x;
    Vec3 hit;
    Vec3 weights;
    double share = 0.0;
    const int met = locator->IntersectWithLine(centre.data(), end.data(), /*tol=*/0.0, share, hit.data(),
                                               weights.data(), part, id, cell);
    return met != 0 ? share * length : kNoSurface;
  }

  double closest(const Vec3& x) {
    Vec3 nearest;
    double squared = 0.0;
    locator->FindClosestPoint(x.data(), nearest.data(), cell, id, part, squared);
    return std::sqrt(squared);
  }

  double heap_before;
  double farthest = 0.0;  // vertex from the centre, mm
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkStaticCellLocator> locator;
  double bytes = 0.0;
  // VTK wants pointers to what it fills, asked for or not.
  vtkNew<vtkGenericCell> cell;
  vtkIdType id = -1;
  int part = 0;
};

GapCase locator_case(const AskedSurface& surface, const char* name, const char* label, Measure measure,
                     int place, double (LocatedSurface::*answer)(const Vec3&)) {
  PointCase one = library_case(name, label, measure, [&mesh = surface.mesh, answer] {
    const auto located = std::make_shared<LocatedSurface>(mesh);
    return one_by_one([located, answer](const Vec3& x) { return (*located.*answer)(x); }, located->bytes);
  });
  one.setting = "buckets";
  one.place = place;
  return point_gaps(surface, one);
}

struct Collision {
  explicit Collision(const BallSocketPair& pair) {
    to_vtk(pair.ball, *ball);
    to_vtk(pair.socket, *socket);
    filter->SetInputData(0, ball);
    filter->SetInputData(1, socket);
    filter->SetMatrix(0, placed);
    filter->SetMatrix(1, fixed);
    filter->SetCollisionModeToFirstContact();
    filter->GenerateScalarsOff();
  }

  bool touches(const Pose& pose) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) placed->SetElement(row, column, pose.rotation(row, column));
      placed->SetElement(row, 3, pose.translation(row));
    }
    filter->Modified();  // also where the pose is that of before
    filter->Update();
    return filter->GetNumberOfContacts() > 0;
  }

  vtkNew<vtkPolyData> ball;
  vtkNew<vtkPolyData> socket;
  vtkNew<vtkMatrix4x4> placed;
  vtkNew<vtkMatrix4x4> fixed;
  vtkNew<vtkCollisionDetectionFilter> filter;
};

Touch vtk_touch(const BallSocketPair& pair) {
  const auto collision = std::make_shared<Collision>(pair);
  collision->touches({});
  return [collision](const Pose& pose) { return collision->touches(pose); };
}

}  // namespace

Method vtk_method() {
  Method method;
  method.gaps = [](const AskedSurface& surface, const GapSizes&) {
    std::vector cases{locator_case(surface, "vtk_first_hit", "VTK, first hit", Measure::radial, 61,
                                   &LocatedSurface::first_hit),
                      locator_case(surface, "vtk_closest", "VTK, closest point", Measure::euclidean, 63,
                                   &LocatedSurface::closest)};
    cases[0].first_hit = true;
    return cases;
  };
  method.contact = [](const BallSocketPair& pair) {
    ContactCase one = touch_only("vtk_collide", "VTK, touch", 2, pair, vtk_touch);
    one.few = true;
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
