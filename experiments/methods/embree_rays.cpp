// SPDX-License-Identifier: GPL-3.0-or-later
// @can     points gaps
// @links   gap gap_queries peer::embree
//
// Methods embree_ray1, embree_ray8 and embree_ray16: the layer of a surface that counts along a ray from the
// centre, by Embree, with 1, 8 or 16 rays at a time. It is the first triangle that the ray meets, or the
// last, by a filter that refuses all. Rays and triangles are in float.

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "methods/embree_scene.hpp"
#include "methods/gaps.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr float kForever = std::numeric_limits<float>::infinity();

constexpr std::size_t kMostRays = 16;  // of a packet

// A surface and its layer that counts.
struct Asked {
  EmbreeScene scene;
  Layer layer = Layer::nearest;
};

// A query with the farthest crossing of each ray, in units of its point's distance.
struct Query : RTCIntersectContext {
  explicit Query(const Asked& asked) {
    rtcInitIntersectContext(this);
    if (asked.layer == Layer::farthest) filter = keep_farthest;
  }

  // Keeps a crossing and refuses it, so that the ray goes on.
  static void keep_farthest(const RTCFilterFunctionNArguments* found) {
    auto& query = *static_cast<Query*>(found->context);
    for (unsigned k = 0; k < found->N; ++k) {
      if (found->valid[k] == 0) continue;
      float& farthest = query.farthest[RTCRayN_id(found->ray, found->N, k)];
      farthest = std::max(farthest, RTCRayN_tfar(found->ray, found->N, k));
      found->valid[k] = 0;
    }
  }

  double radius(std::size_t ray, unsigned geometry, float first, const Vec3& x) const {
    const bool met = filter == nullptr ? geometry != RTC_INVALID_GEOMETRY_ID : farthest[ray] > 0.0F;
    if (!met) return kNoSurface;
    return static_cast<double>(filter == nullptr ? first : farthest[ray]) * x.norm();
  }

  std::array<float, kMostRays> farthest{};
};

double cast_one(const Asked& asked, const Vec3& x) {
  Query query(asked);
  RTCRayHit ray{};
  ray.ray.dir_x = static_cast<float>(x.x());
  ray.ray.dir_y = static_cast<float>(x.y());
  ray.ray.dir_z = static_cast<float>(x.z());
  ray.ray.tfar = kForever;
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(asked.scene.get(), &query, &ray);
  return query.radius(0, ray.hit.geomID, ray.ray.tfar, x);
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
  Query query(asked);
  Packet rays{};
  alignas(64) int valid[kWidth<Packet>] = {};
  for (std::size_t k = 0; k < points.size(); ++k) {
    valid[k] = -1;
    rays.ray.dir_x[k] = static_cast<float>(points[k].x());
    rays.ray.dir_y[k] = static_cast<float>(points[k].y());
    rays.ray.dir_z[k] = static_cast<float>(points[k].z());
    rays.ray.tfar[k] = kForever;
    rays.ray.mask[k] = ~0U;
    rays.ray.id[k] = static_cast<unsigned>(k);
    rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect(valid, asked.scene.get(), &query, &rays);
  for (std::size_t k = 0; k < points.size(); ++k)
    out[k] = query.radius(k, rays.hit.geomID[k], rays.ray.tfar[k], points[k]);
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

PointQuery rays(const TriangleMesh& mesh, Layer layer, int width, EmbreeQuality quality) {
  const auto asked =
      std::shared_ptr<const Asked>(new Asked{{mesh, quality, layer == Layer::farthest}, layer});
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
