// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/vtk_distances.hpp"

#include <algorithm>
#include <cmath>

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include "imaging/vtk_surface.hpp"
#include "methods/heap_use.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

// VTK wants pointers to what it fills, asked for or not.
struct FoundCell {
  vtkNew<vtkGenericCell> cell;
  vtkIdType id = -1;
  int part = 0;
};

struct LocatedSurface {
  explicit LocatedSurface(const TriangleMesh& mesh) : heap_before(heap_bytes()) {
    for (const Vec3& v : mesh.vertices) farthest = std::max(farthest, v.norm());
    to_vtk(mesh, *surface);
    locator->SetDataSet(surface);
    locator->BuildLocator();
    bytes = heap_bytes() - heap_before;
  }

  double heap_before;
  double farthest = 0.0;  // vertex from the centre, mm
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkStaticCellLocator> locator;
  double bytes = 0.0;
};

class VtkFirstHit final : public RadiusMethod {
 public:
  explicit VtkFirstHit(const TriangleMesh& mesh) : located_(mesh) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    const Vec3 centre = Vec3::Zero();
    const double length = 2.0 * located_.farthest;
    Vec3 hit;
    Vec3 weights;
    double share = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 end = length / points[i].norm() * points[i];
      const int met =
          located_.locator->IntersectWithLine(centre.data(), end.data(), /*tol=*/0.0, share, hit.data(),
                                              weights.data(), found_.part, found_.id, found_.cell);
      out[i] = met != 0 ? share * length : kNoSurface;
    }
  }
  double bytes() const override { return located_.bytes; }

 private:
  LocatedSurface located_;
  FoundCell found_;
};

class VtkClosest final : public RadiusMethod {
 public:
  explicit VtkClosest(const TriangleMesh& mesh) : located_(mesh) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    Vec3 nearest;
    double squared = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      located_.locator->FindClosestPoint(points[i].data(), nearest.data(), found_.cell, found_.id,
                                         found_.part, squared);
      out[i] = std::sqrt(squared);
    }
  }
  double bytes() const override { return located_.bytes; }

 private:
  LocatedSurface located_;
  FoundCell found_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_vtk_first_hit(const TriangleMesh& mesh) {
  return std::make_unique<VtkFirstHit>(mesh);
}

std::unique_ptr<RadiusMethod> make_vtk_closest(const TriangleMesh& mesh) {
  return std::make_unique<VtkClosest>(mesh);
}

}  // namespace impinge::lab
