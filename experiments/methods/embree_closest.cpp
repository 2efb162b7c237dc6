// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries peer::embree
//
// Method embree_closest: distance of a point from the surface by Embree's point query. Embree walks its tree
// in float and leaves the distance from a triangle to the caller, which computes it in double here.

#include <cmath>
#include <limits>
#include <utility>

#include "mesh/triangle_distance.hpp"
#include "methods/embree_scene.hpp"
#include "methods/gaps.hpp"

namespace impinge::lab {
namespace {

// Input and result of visiting a triangle.
struct Search {
  const TriangleMesh* mesh;
  Vec3 point;
  double squared;  // of the nearest so far, mm^2
};

// Shrinks the radius of the query to the distance, rounded up, so that the tree skips what is farther.
bool visit_triangle(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  const Face& face = search.mesh->faces[arguments->primID];
  const double squared =
      squared_distance_to_triangle(search.point, corner(*search.mesh, face, 0), corner(*search.mesh, face, 1),
                                   corner(*search.mesh, face, 2));
  if (!(squared < search.squared)) return false;
  search.squared = squared;
  arguments->query->radius =
      std::nextafter(static_cast<float>(std::sqrt(squared)), std::numeric_limits<float>::infinity());
  return true;
}

// Embree's tree with a copy of the mesh.
struct Searched {
  explicit Searched(TriangleMesh of) : mesh(std::move(of)), scene(mesh, EmbreeQuality::robust) {}

  double distance(const Vec3& x) const {
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    Search search{&mesh, x, std::numeric_limits<double>::infinity()};
    RTCPointQuery query{};
    query.x = static_cast<float>(x.x());
    query.y = static_cast<float>(x.y());
    query.z = static_cast<float>(x.z());
    query.radius = std::numeric_limits<float>::infinity();
    rtcPointQuery(scene.get(), &query, &context, visit_triangle, &search);
    return std::sqrt(search.squared);
  }

  TriangleMesh mesh;
  EmbreeScene scene;
};

PointCase closest(const TriangleMesh& mesh) {
  PointCase one = library_case("embree_closest", "Embree, closest point", Measure::euclidean, [&mesh] {
    const auto surface = std::make_shared<const Searched>(mesh);
    const std::size_t copied = mesh.vertices.size() * sizeof(Vec3) + mesh.faces.size() * sizeof(Face);
    return one_by_one([surface](const Vec3& x) { return surface->distance(x); },
                      surface->scene.bytes() + static_cast<double>(copied));
  });
  one.setting = "robust";
  return one;
}

}  // namespace

Method embree_closest_method() {
  Method method;
  method.points = [](const BenchmarkScene& scene, const PointSizes&) {
    PointCase one = closest(scene.surface());
    one.place = 11;
    return std::vector{one};
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes&) {
    GapCase one = point_gaps(surface, closest(surface.mesh));
    one.place = 64;
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
