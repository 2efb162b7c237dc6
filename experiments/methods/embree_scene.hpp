// SPDX-License-Identifier: GPL-3.0-or-later
// A surface in Embree 3: its tree over the triangles, in float, built and kept by one thread.
#pragma once

#include <cstddef>
#include <memory>

#include <embree3/rtcore.h>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// `robust` asks for intersections that let no ray slip through an edge; `fast` is Embree's default.
enum class EmbreeQuality { fast, robust };

class EmbreeScene {
 public:
  // mesh in the centre frame; may queries bring a filter of their own? Throws std::runtime_error when Embree
  // refuses.
  EmbreeScene(const TriangleMesh& mesh, EmbreeQuality quality, bool filtered = false);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  RTCScene get() const { return scene_; }  // to ask, while this object lives

  // What Embree's memory monitor counted: tree, vertices and triangles.
  double bytes() const { return static_cast<double>(bytes_); }

 private:
  static bool count(void* self, ssize_t bytes, bool post);

  std::ptrdiff_t bytes_ = 0;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace impinge::lab
