// SPDX-License-Identifier: GPL-3.0-or-later
// Methods embree_ray1, embree_ray8 and embree_ray16: the first triangle that a ray from the centre meets, by
// Embree, one ray at a time or 8 or 16 in a packet. Rays and triangles in float.
#pragma once

#include <memory>

#include "methods/embree_scene.hpp"
#include "methods/radius_method.hpp"

namespace impinge::lab {

struct EmbreeRays {
  int width = 1;                                // 1, 8 or 16
  EmbreeQuality quality = EmbreeQuality::fast;  // of the intersections
};

// Throws std::invalid_argument for another width.
std::unique_ptr<RadiusMethod> make_embree_rays(const TriangleMesh& mesh, const EmbreeRays& rays);

}  // namespace impinge::lab
