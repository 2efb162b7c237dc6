// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/embree_closest.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "mesh/triangle_distance.hpp"
#include "methods/embree_scene.hpp"

namespace impinge::lab {
namespace {

// What a triangle's visit needs and leaves.
struct Search {
  const TriangleMesh* mesh;
  Vec3 point;
  double squared;  // of the nearest so far, mm^2
};

// The radius of the query shrinks to the distance, rounded up, so that the tree leaves out what is farther.
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

class EmbreeClosest final : public RadiusMethod {
 public:
  explicit EmbreeClosest(TriangleMesh mesh) : mesh_(std::move(mesh)), scene_(mesh_, EmbreeQuality::robust) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = distance(points[i]);
  }

  double bytes() const override {
    return scene_.bytes() + static_cast<double>(mesh_.vertices.size() * sizeof(Vec3)) +
           static_cast<double>(mesh_.faces.size() * sizeof(Face));
  }

 private:
  double distance(const Vec3& x) const {
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    Search search{&mesh_, x, std::numeric_limits<double>::infinity()};
    RTCPointQuery query{};
    query.x = static_cast<float>(x.x());
    query.y = static_cast<float>(x.y());
    query.z = static_cast<float>(x.z());
    query.radius = std::numeric_limits<float>::infinity();
    rtcPointQuery(scene_.get(), &query, &context, visit_triangle, &search);
    return std::sqrt(search.squared);
  }

  TriangleMesh mesh_;
  EmbreeScene scene_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_embree_closest(const TriangleMesh& mesh) {
  return std::make_unique<EmbreeClosest>(mesh);
}

}  // namespace impinge::lab
