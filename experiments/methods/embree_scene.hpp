// SPDX-License-Identifier: GPL-3.0-or-later
// A surface in Embree 3: its tree of triangles, in float, made and used by one thread.
#pragma once

#include <cstddef>
#include <memory>

#include <embree3/rtcore.h>

#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// `robust` uses intersections that let no ray slip through an edge; `fast` is Embree's default.
enum class EmbreeQuality { fast, robust };

class EmbreeScene {
 public:
  // `mesh` is in the centre frame. `filtered`: may queries bring their own filter? Throws
  // std::runtime_error if Embree refuses.
  EmbreeScene(const TriangleMesh& mesh, EmbreeQuality quality, bool filtered = false);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  RTCScene get() const { return scene_; }  // valid while this object lives

  // Bytes counted by Embree's memory monitor: tree, vertices and triangles.
  double bytes() const { return static_cast<double>(bytes_); }

 private:
  static bool count(void* self, ssize_t bytes, bool post);

  std::ptrdiff_t bytes_ = 0;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace impinge::lab
