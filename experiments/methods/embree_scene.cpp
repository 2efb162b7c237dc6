// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/embree_scene.hpp"

#include <stdexcept>

namespace impinge::lab {
namespace {

void fill(RTCGeometry geometry, const TriangleMesh& mesh) {
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.faces.size()));
  if (points == nullptr || corners == nullptr)
    throw std::runtime_error("Embree has no memory for a surface: use one with fewer triangles");
  for (const Vec3& vertex : mesh.vertices) {
    for (const double x : vertex) *points++ = static_cast<float>(x);
  }
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) *corners++ = v;
  }
}

}  // namespace

bool EmbreeScene::count(void* self, ssize_t bytes, bool /*post*/) {
  static_cast<EmbreeScene*>(self)->bytes_ += bytes;
  return true;
}

EmbreeScene::EmbreeScene(const TriangleMesh& mesh, EmbreeQuality quality, bool filtered)
    : device_(rtcNewDevice("threads=1,set_affinity=0")) {
  if (device_ == nullptr) throw std::runtime_error("Embree does not start on this machine");
  rtcSetDeviceMemoryMonitorFunction(device_, &EmbreeScene::count, this);
  scene_ = rtcNewScene(device_);
  const RTCSceneFlags none = RTC_SCENE_FLAG_NONE;
  rtcSetSceneFlags(scene_, (quality == EmbreeQuality::robust ? RTC_SCENE_FLAG_ROBUST : none) |
                               (filtered ? RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION : none));
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill(geometry, mesh);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

}  // namespace impinge::lab
