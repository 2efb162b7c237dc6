// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/embree_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr float kForever = std::numeric_limits<float>::infinity();

// A ray's parameter is in lengths of the point that it passes.
double radius_of(unsigned geometry, float parameter, const Vec3& point) {
  return geometry == RTC_INVALID_GEOMETRY_ID ? kNoSurface : static_cast<double>(parameter) * point.norm();
}

class SingleRays final : public RadiusMethod {
 public:
  SingleRays(const TriangleMesh& mesh, EmbreeQuality quality) : scene_(mesh, quality) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = cast(points[i]);
  }
  double bytes() const override { return scene_.bytes(); }

 private:
  double cast(const Vec3& x) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.dir_x = static_cast<float>(x.x());
    ray.ray.dir_y = static_cast<float>(x.y());
    ray.ray.dir_z = static_cast<float>(x.z());
    ray.ray.tfar = kForever;
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &ray);
    return radius_of(ray.hit.geomID, ray.ray.tfar, x);
  }

  EmbreeScene scene_;
};

void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* rays) {
  rtcIntersect8(valid, scene, context, rays);
}
void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* rays) {
  rtcIntersect16(valid, scene, context, rays);
}

template <class Packet>
class PacketRays final : public RadiusMethod {
 public:
  PacketRays(const TriangleMesh& mesh, EmbreeQuality quality) : scene_(mesh, quality) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t begin = 0; begin < points.size(); begin += kWidth) {
      const std::size_t count = std::min(kWidth, points.size() - begin);
      cast(points.subspan(begin, count), out.subspan(begin, count));
    }
  }
  double bytes() const override { return scene_.bytes(); }

 private:
  static constexpr std::size_t kWidth = std::extent_v<decltype(Packet{}.ray.dir_x)>;

  void cast(std::span<const Vec3> points, std::span<double> out) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    Packet rays{};
    alignas(64) int valid[kWidth] = {};
    for (std::size_t k = 0; k < points.size(); ++k) {
      valid[k] = -1;
      rays.ray.dir_x[k] = static_cast<float>(points[k].x());
      rays.ray.dir_y[k] = static_cast<float>(points[k].y());
      rays.ray.dir_z[k] = static_cast<float>(points[k].z());
      rays.ray.tfar[k] = kForever;
      rays.ray.mask[k] = ~0U;
      rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    }
    intersect(valid, scene_.get(), &context, &rays);
    for (std::size_t k = 0; k < points.size(); ++k)
      out[k] = radius_of(rays.hit.geomID[k], rays.ray.tfar[k], points[k]);
  }

  EmbreeScene scene_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_embree_rays(const TriangleMesh& mesh, const EmbreeRays& rays) {
  switch (rays.width) {
    case 1:
      return std::make_unique<SingleRays>(mesh, rays.quality);
    case 8:
      return std::make_unique<PacketRays<RTCRayHit8>>(mesh, rays.quality);
    case 16:
      return std::make_unique<PacketRays<RTCRayHit16>>(mesh, rays.quality);
    default:
      throw std::invalid_argument("Embree takes 1, 8 or 16 rays at a time, not " +
                                  std::to_string(rays.width));
  }
}

}  // namespace impinge::lab
