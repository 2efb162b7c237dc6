// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/cgal_distances.hpp"

#include <cmath>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include "methods/exact_triangles.hpp"
#include "methods/heap_use.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

using Point = ExactPredicates::Point_3;
using Triangles = std::vector<ExactPredicates::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<ExactPredicates, Triangles::const_iterator>;
using BoxTree = CGAL::AABB_tree<CGAL::AABB_traits<ExactPredicates, Primitive>>;

struct SurfaceTree {
  SurfaceTree(const TriangleMesh& mesh, bool for_distances)
      : heap_before(heap_bytes()),
        triangles(exact_triangles(mesh)),
        tree(triangles.cbegin(), triangles.cend()) {
    tree.build();
    if (for_distances)
      tree.accelerate_distance_queries();
    else
      tree.do_not_accelerate_distance_queries();
    bytes = heap_bytes() - heap_before;
  }

  double heap_before;
  Triangles triangles;
  BoxTree tree;
  double bytes = 0.0;
};

// A segment is met where a ray lies in the plane of a face: its end nearer to the centre.
struct NearestPoint {
  using result_type = double;
  double operator()(const Point& p) const {
    return std::sqrt(CGAL::squared_distance(p, Point(CGAL::ORIGIN)));
  }
  double operator()(const ExactPredicates::Segment_3& s) const {
    return std::min((*this)(s.source()), (*this)(s.target()));
  }
};

class CgalFirstHit final : public RadiusMethod {
 public:
  explicit CgalFirstHit(const TriangleMesh& mesh) : surface_(mesh, /*for_distances=*/false) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& x = points[i];
      const ExactPredicates::Ray_3 ray(Point(CGAL::ORIGIN), Point(x.x(), x.y(), x.z()));
      const auto hit = surface_.tree.first_intersection(ray);
      out[i] = hit ? boost::apply_visitor(NearestPoint{}, hit->first) : kNoSurface;
    }
  }
  double bytes() const override { return surface_.bytes; }

 private:
  SurfaceTree surface_;
};

class CgalClosest final : public RadiusMethod {
 public:
  explicit CgalClosest(const TriangleMesh& mesh) : surface_(mesh, /*for_distances=*/true) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& x = points[i];
      out[i] = std::sqrt(surface_.tree.squared_distance(Point(x.x(), x.y(), x.z())));
    }
  }
  double bytes() const override { return surface_.bytes; }

 private:
  SurfaceTree surface_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_cgal_first_hit(const TriangleMesh& mesh) {
  return std::make_unique<CgalFirstHit>(mesh);
}

std::unique_ptr<RadiusMethod> make_cgal_closest(const TriangleMesh& mesh) {
  return std::make_unique<CgalClosest>(mesh);
}

}  // namespace impinge::lab
