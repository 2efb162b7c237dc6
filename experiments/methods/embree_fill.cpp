// SPDX-License-Identifier: GPL-3.0-or-later
// @can     fill
// @links   gap table_fill peer::embree
//
// Method embree_fill: what a table asks of a surface, by Embree: its tree, then coherent rays from the
// centre, 16 in a packet, along the directions of the entries.

#include <algorithm>
#include <limits>

#include "files/thread_team.hpp"
#include "methods/embree_scene.hpp"
#include "methods/fill.hpp"
#include "sphere/table_memory.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kPacket = 16;
constexpr double kMostMissed = 0.01;  // of the rays
constexpr double kRayError = 1e-3;    // mm, of a ray in float

void cast_packet(RTCScene scene, const FloatDirections& directions, const Share& rays, float* radii) {
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

// The tree is built by one thread.
struct Rays {
  FilledSurface surface;
  std::size_t threads;
  TableMemory<float> radii = {};

  void fill() {
    const EmbreeScene scene(surface.mesh, EmbreeQuality::fast);
    const std::size_t count = surface.directions->x.size();
    radii.resize(count);
    on_threads(threads, [&](std::size_t thread) {
      const Share share = share_of(count, thread, threads);
      for (std::size_t first = share.first; first < share.end; first += kPacket) {
        const Share packet{first, std::min(first + kPacket, share.end)};
        cast_packet(scene.get(), *surface.directions, packet, radii.data() + first);
      }
    });
  }
};

TableFilling make_filling(const FilledSurface& surface, int threads) {
  const auto rays = std::make_shared<Rays>(Rays{surface, static_cast<std::size_t>(threads)});
  return {[rays] { rays->fill(); }, [rays] { rays->radii = {}; },
          [rays](std::size_t entry) { return static_cast<double>(rays->radii[entry]); },
          [] { return kRayError; }};
}

}  // namespace

Method embree_fill_method() {
  Method method{.name = "embree_fill", .label = "Embree, tree and rays"};
  method.lacks = "the farthest layer, since a ray ends at its first triangle";
  method.fill = [] {
    FillCase one;
    one.storage = "float";
    one.most_off = kMostMissed;
    one.make = make_filling;
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
