// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries peer::embree
//
// Methods embree_ray1, embree_ray8 and embree_ray16: the layer of a surface that counts, by Embree, one ray
// at a time or 8 or 16 in a packet. For the nearest it is the first triangle that a ray from the centre
// meets; for the farthest the first that a ray from beyond the surface to the centre meets. Rays and
// triangles in float.

#include <algorithm>
#include <limits>
#include <type_traits>

#include "methods/embree_scene.hpp"
#include "methods/gaps.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr float kForever = std::numeric_limits<float>::infinity();

// A surface and where its rays begin.
struct Asked {
  EmbreeScene scene;
  double from = 0.0;  // mm from the centre: 0, or beyond the surface
};

// In lengths of the point that it passes.
struct Ray {
  Eigen::Vector3f from;
  Eigen::Vector3f way;
  float length;
};

Ray ray_through(const Asked& asked, const Vec3& x) {
  const Eigen::Vector3f way = x.cast<float>();
  if (asked.from == 0.0) return {Eigen::Vector3f::Zero(), way, kForever};
  const double begin = asked.from / x.norm();
  return {(begin * x).cast<float>(), -way, static_cast<float>(begin)};
}

double radius_of(const Asked& asked, unsigned geometry, float parameter, const Vec3& x) {
  if (geometry == RTC_INVALID_GEOMETRY_ID) return kNoSurface;
  return std::abs(asked.from - static_cast<double>(parameter) * x.norm());
}

double cast_one(const Asked& asked, const Vec3& x) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const Ray of = ray_through(asked, x);
  RTCRayHit ray{};
  ray.ray.org_x = of.from.x();
  ray.ray.org_y = of.from.y();
  ray.ray.org_z = of.from.z();
  ray.ray.dir_x = of.way.x();
  ray.ray.dir_y = of.way.y();
  ray.ray.dir_z = of.way.z();
  ray.ray.tfar = of.length;
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(asked.scene.get(), &context, &ray);
  return radius_of(asked, ray.hit.geomID, ray.ray.tfar, x);
}

void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* rays) {
  rtcIntersect8(valid, scene, context, rays);
}
void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* rays) {
  rtcIntersect16(valid, scene, context, rays);
}

template <class Packet>
constexpr std::size_t kWidth = std::extent_v<decltype(Packet{}.ray.dir_x)>;

template <class Packet>
void cast_packet(const Asked& asked, std::span<const Vec3> points, std::span<double> out) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  Packet rays{};
  alignas(64) int valid[kWidth<Packet>] = {};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Ray of = ray_through(asked, points[k]);
    valid[k] = -1;
    rays.ray.org_x[k] = of.from.x();
    rays.ray.org_y[k] = of.from.y();
    rays.ray.org_z[k] = of.from.z();
    rays.ray.dir_x[k] = of.way.x();
    rays.ray.dir_y[k] = of.way.y();
    rays.ray.dir_z[k] = of.way.z();
    rays.ray.tfar[k] = of.length;
    rays.ray.mask[k] = ~0U;
    rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect(valid, asked.scene.get(), &context, &rays);
  for (std::size_t k = 0; k < points.size(); ++k)
    out[k] = radius_of(asked, rays.hit.geomID[k], rays.ray.tfar[k], points[k]);
}

template <class Packet>
PointQuery packets(const std::shared_ptr<const Asked>& asked) {
  return {[asked](std::span<const Vec3> points, std::span<double> out) {
            for (std::size_t begin = 0; begin < points.size(); begin += kWidth<Packet>) {
              const std::size_t count = std::min(kWidth<Packet>, points.size() - begin);
              cast_packet<Packet>(*asked, points.subspan(begin, count), out.subspan(begin, count));
            }
          },
          asked->scene.bytes()};
}

double beyond(const TriangleMesh& mesh) {
  double radius = 0.0;
  for (const Vec3& v : mesh.vertices) radius = std::max(radius, v.norm());
  return 1.01 * radius;
}

PointQuery rays(const TriangleMesh& mesh, Layer layer, int width, EmbreeQuality quality) {
  const auto asked =
      std::shared_ptr<const Asked>(new Asked{{mesh, quality}, layer == Layer::nearest ? 0.0 : beyond(mesh)});
  if (width == 8) return packets<RTCRayHit8>(asked);
  if (width == 16) return packets<RTCRayHit16>(asked);
  return one_by_one([asked](const Vec3& x) { return cast_one(*asked, x); }, asked->scene.bytes());
}

PointCase rays_case(const TriangleMesh& mesh, Layer layer, int width, bool robust) {
  const std::string many = std::to_string(width);
  PointCase one =
      library_case("embree_ray" + many, "Embree, " + (width == 1 ? "a ray" : many + " rays") + " at a time",
                   Measure::radial, [&mesh, layer, width, robust] {
                     return rays(mesh, layer, width, robust ? EmbreeQuality::robust : EmbreeQuality::fast);
                   });
  one.setting = robust ? "robust" : "fast";
  one.place = 10;
  one.in_float = true;
  if (width == 1) one.stability = "embree_" + one.setting;
  return one;
}

}  // namespace

Method embree_rays_method() {
  Method method;
  method.points = [](const BenchmarkScene& scene, const PointSizes&) {
    std::vector<PointCase> cases;
    for (const bool robust : {false, true})
      for (const int width : {1, 8, 16})
        cases.push_back(rays_case(scene.surface(), BenchmarkScene::kLayer, width, robust));
    return cases;
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes&) {
    std::vector<GapCase> cases;
    for (const int width : {1, 8, 16}) {
      cases.push_back(point_gaps(surface, rays_case(surface.mesh, surface.layer, width, /*robust=*/false)));
      cases.back().label = "Embree, " + std::to_string(width) + (width == 1 ? " ray" : " rays");
      cases.back().few = false;
    }
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
