// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries heap_use CGAL::CGAL

#include "methods/cgal.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include "methods/exact_triangles.hpp"
#include "methods/gaps.hpp"
#include "methods/heap_use.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

using Point3 = ExactPredicates::Point_3;
using TriangleList = std::vector<ExactPredicates::Triangle_3>;
using TreeTriangle = CGAL::AABB_triangle_primitive<ExactPredicates, TriangleList::const_iterator>;
using TriangleTree = CGAL::AABB_tree<CGAL::AABB_traits<ExactPredicates, TreeTriangle>>;

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
  TriangleList triangles;
  TriangleTree tree;
  double bytes = 0.0;
};

// A segment is met where a ray lies in the plane of a face: its end nearer to the centre.
struct NearestPoint {
  using result_type = double;
  double operator()(const Point3& p) const {
    return std::sqrt(CGAL::squared_distance(p, Point3(CGAL::ORIGIN)));
  }
  double operator()(const ExactPredicates::Segment_3& s) const {
    return std::min((*this)(s.source()), (*this)(s.target()));
  }
};

PointCase first_hit_case(const TriangleMesh& mesh) {
  PointCase one = library_case("cgal_first_hit", "CGAL, first hit", Measure::radial,
                               [&mesh] { return make_cgal_first_hit(mesh); });
  one.stability = one.name;
  return one;
}

PointCase closest_case(const TriangleMesh& mesh) {
  return library_case("cgal_closest", "CGAL, closest point", Measure::euclidean,
                      [&mesh] { return make_cgal_closest(mesh); });
}

}  // namespace

PointQuery make_cgal_first_hit(const TriangleMesh& mesh) {
  const auto surface = std::make_shared<const SurfaceTree>(mesh, /*for_distances=*/false);
  return one_by_one(
      [surface](const Vec3& x) {
        const ExactPredicates::Ray_3 ray(Point3(CGAL::ORIGIN), Point3(x.x(), x.y(), x.z()));
        const auto hit = surface->tree.first_intersection(ray);
        return hit ? boost::apply_visitor(NearestPoint{}, hit->first) : kNoSurface;
      },
      surface->bytes);
}

PointQuery make_cgal_closest(const TriangleMesh& mesh) {
  const auto surface = std::make_shared<const SurfaceTree>(mesh, /*for_distances=*/true);
  return one_by_one(
      [surface](const Vec3& x) {
        return std::sqrt(surface->tree.squared_distance(Point3(x.x(), x.y(), x.z())));
      },
      surface->bytes);
}

Touch make_cgal_tree(const TriangleMesh& ball, const TriangleMesh& socket) {
  return [ball,
          surface = std::make_shared<const SurfaceTree>(socket, /*for_distances=*/false)](const Pose& pose) {
    return std::ranges::any_of(exact_triangles(ball, pose),
                               [&](const auto& triangle) { return surface->tree.do_intersect(triangle); });
  };
}

Method cgal_method() {
  Method method;
  method.points = [](const BenchmarkScene& scene, const PointSizes&) {
    std::vector cases{first_hit_case(scene.surface()), closest_case(scene.surface())};
    for (PointCase& one : cases) one.place = 12;
    return cases;
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes&) {
    std::vector cases{point_gaps(surface, first_hit_case(surface.mesh)),
                      point_gaps(surface, closest_case(surface.mesh))};
    for (GapCase& one : cases) one.setting = "tree";
    cases[0].place = 60;
    cases[0].first_hit = true;
    cases[1].place = 62;
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
