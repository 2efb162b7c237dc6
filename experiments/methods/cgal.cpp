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

// Position of a hit along x, negative behind the centre. If a ray lies in the plane of a face it meets a
// segment, and its first end counts.
struct RadiusOfHit {
  using result_type = double;
  const Vec3& x;
  bool inwards;
  double operator()(const Point3& p) const {
    const Vec3 hit(p.x(), p.y(), p.z());
    return std::copysign(hit.norm(), hit.dot(x));
  }
  double operator()(const ExactPredicates::Segment_3& s) const {
    const auto [low, high] = std::minmax({(*this)(s.source()), (*this)(s.target())});
    return inwards ? high : low;
  }
};

// First hit along x, outwards from the centre, or inwards from `beyond` the surface, mm.
double first_radius(const TriangleTree& tree, const Vec3& x, double beyond) {
  const bool inwards = beyond > 0.0;
  const Vec3 from = inwards ? Vec3(beyond / x.norm() * x) : Vec3(Vec3::Zero());
  const Vec3 to = inwards ? Vec3(Vec3::Zero()) : x;
  const ExactPredicates::Ray_3 ray(Point3(from.x(), from.y(), from.z()), Point3(to.x(), to.y(), to.z()));
  const auto hit = tree.first_intersection(ray);
  if (!hit) return kNoSurface;
  const double radius = boost::apply_visitor(RadiusOfHit{x, inwards}, hit->first);
  return radius >= 0.0 ? radius : kNoSurface;
}

PointCase first_hit_case(const TriangleMesh& mesh, Layer layer) {
  PointCase one = library_case("cgal_first_hit", "CGAL, first hit", Measure::radial,
                               [&mesh, layer] { return make_cgal_first_hit(mesh, layer); });
  one.stability = one.name;
  return one;
}

PointCase closest_case(const TriangleMesh& mesh) {
  return library_case("cgal_closest", "CGAL, closest point", Measure::euclidean,
                      [&mesh] { return make_cgal_closest(mesh); });
}

}  // namespace

PointQuery make_cgal_first_hit(const TriangleMesh& mesh, Layer layer) {
  const auto surface = std::make_shared<const SurfaceTree>(mesh, /*for_distances=*/false);
  double beyond = 0.0;
  if (layer == Layer::farthest)
    for (const Vec3& v : mesh.vertices) beyond = std::max(beyond, 1.01 * v.norm());
  return one_by_one([surface, beyond](const Vec3& x) { return first_radius(surface->tree, x, beyond); },
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
    std::vector cases{first_hit_case(scene.surface(), BenchmarkScene::kLayer), closest_case(scene.surface())};
    for (PointCase& one : cases) one.place = 12;
    return cases;
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes&) {
    std::vector cases{point_gaps(surface, first_hit_case(surface.mesh, surface.layer)),
                      point_gaps(surface, closest_case(surface.mesh))};
    for (GapCase& one : cases) one.setting = "tree";
    cases[0].place = 60;
    cases[1].place = 62;
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
