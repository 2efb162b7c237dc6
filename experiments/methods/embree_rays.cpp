// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries peer::embree
//
// Methods embree_ray1, embree_ray8 and embree_ray16: the first triangle that a ray from the centre meets, by
// Embree, one ray at a time or 8 or 16 in a packet. Rays and triangles in float.

#include <algorithm>
#include <limits>
#include <type_traits>

#include "methods/embree_scene.hpp"
#include "methods/gaps.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr float kForever = std::numeric_limits<float>::infinity();

// A ray's parameter is in lengths of the point that it passes.
double radius_of(unsigned geometry, float parameter, const Vec3& point) {
  return geometry == RTC_INVALID_GEOMETRY_ID ? kNoSurface : static_cast<double>(parameter) * point.norm();
}

double cast_one(RTCScene scene, const Vec3& x) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray.dir_x = static_cast<float>(x.x());
  ray.ray.dir_y = static_cast<float>(x.y());
  ray.ray.dir_z = static_cast<float>(x.z());
  ray.ray.tfar = kForever;
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &ray);
  return radius_of(ray.hit.geomID, ray.ray.tfar, x);
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
void cast_packet(RTCScene scene, std::span<const Vec3> points, std::span<double> out) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  Packet rays{};
  alignas(64) int valid[kWidth<Packet>] = {};
  for (std::size_t k = 0; k < points.size(); ++k) {
    valid[k] = -1;
    rays.ray.dir_x[k] = static_cast<float>(points[k].x());
    rays.ray.dir_y[k] = static_cast<float>(points[k].y());
    rays.ray.dir_z[k] = static_cast<float>(points[k].z());
    rays.ray.tfar[k] = kForever;
    rays.ray.mask[k] = ~0U;
    rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect(valid, scene, &context, &rays);
  for (std::size_t k = 0; k < points.size(); ++k)
    out[k] = radius_of(rays.hit.geomID[k], rays.ray.tfar[k], points[k]);
}

template <class Packet>
PointQuery packets(const std::shared_ptr<const EmbreeScene>& scene) {
  return {[scene](std::span<const Vec3> points, std::span<double> out) {
            for (std::size_t begin = 0; begin < points.size(); begin += kWidth<Packet>) {
              const std::size_t count = std::min(kWidth<Packet>, points.size() - begin);
              cast_packet<Packet>(scene->get(), points.subspan(begin, count), out.subspan(begin, count));
            }
          },
          scene->bytes()};
}

PointQuery rays(const TriangleMesh& mesh, int width, EmbreeQuality quality) {
  const auto scene = std::make_shared<const EmbreeScene>(mesh, quality);
  if (width == 8) return packets<RTCRayHit8>(scene);
  if (width == 16) return packets<RTCRayHit16>(scene);
  return one_by_one([scene](const Vec3& x) { return cast_one(scene->get(), x); }, scene->bytes());
}

PointCase rays_case(const TriangleMesh& mesh, int width, bool robust) {
  const std::string many = std::to_string(width);
  PointCase one =
      library_case("embree_ray" + many, "Embree, " + (width == 1 ? "a ray" : many + " rays") + " at a time",
                   Measure::radial, [&mesh, width, robust] {
                     return rays(mesh, width, robust ? EmbreeQuality::robust : EmbreeQuality::fast);
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
  method.lacks = "the farthest layer, since a ray ends at its first triangle";
  method.points = [](const BenchmarkScene& scene, const PointSizes&) {
    std::vector<PointCase> cases;
    for (const bool robust : {false, true})
      for (const int width : {1, 8, 16}) cases.push_back(rays_case(scene.surface(), width, robust));
    return cases;
  };
  method.gaps = [](const AskedSurface& surface, const GapSizes&) {
    std::vector<GapCase> cases;
    for (const int width : {1, 8, 16}) {
      cases.push_back(point_gaps(surface, rays_case(surface.mesh, width, /*robust=*/false)));
      cases.back().label = "Embree, " + std::to_string(width) + (width == 1 ? " ray" : " rays");
      cases.back().few = false;
      cases.back().first_hit = true;
    }
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
