// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/embree_fill.hpp"

#include <algorithm>
#include <limits>

namespace impinge::lab {
namespace {

constexpr std::size_t kPacket = 16;

void cast_packet(RTCScene scene, const RayDirections& directions, RayRange rays, float* radii) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit16 packet{};
  alignas(64) int valid[kPacket] = {};
  const std::size_t count = rays.end - rays.first;
  for (std::size_t k = 0; k < count; ++k) {
    valid[k] = -1;
    packet.ray.dir_x[k] = directions.x[rays.first + k];
    packet.ray.dir_y[k] = directions.y[rays.first + k];
    packet.ray.dir_z[k] = directions.z[rays.first + k];
    packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
    packet.ray.mask[k] = ~0U;
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect16(valid, scene, &context, &packet);
  for (std::size_t k = 0; k < count; ++k)
    radii[k] = packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::quiet_NaN()
                                                               : packet.ray.tfar[k];
}

}  // namespace

RayDirections::RayDirections(std::span<const Vec3> directions) {
  for (auto* axis : {&x, &y, &z}) axis->reserve(directions.size());
  for (const Vec3& u : directions) {
    x.push_back(static_cast<float>(u.x()));
    y.push_back(static_cast<float>(u.y()));
    z.push_back(static_cast<float>(u.z()));
  }
}

void cast_coherent(const EmbreeScene& scene, const RayDirections& directions, RayRange rays,
                   std::span<float> radii) {
  for (std::size_t first = rays.first; first < rays.end; first += kPacket) {
    const RayRange packet{first, std::min(first + kPacket, rays.end)};
    cast_packet(scene.get(), directions, packet, radii.data() + first);
  }
}

}  // namespace impinge::lab
