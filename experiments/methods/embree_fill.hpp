// SPDX-License-Identifier: GPL-3.0-or-later
// Method embree_fill: what a table asks of a surface, by Embree: its tree, then coherent rays from the
// centre, 16 in a packet. Embree finds the nearest layer alone.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "methods/embree_scene.hpp"
#include "sphere/direction.hpp"

namespace impinge::lab {

// Directions as Embree reads them, in an order in which those of a packet are near to each other.
struct RayDirections {
  // Unit vectors, kept in the order given.
  explicit RayDirections(std::span<const Vec3> directions);

  std::size_t size() const { return x.size(); }  // number of directions

  std::vector<float> x;  // of each direction
  std::vector<float> y;
  std::vector<float> z;
};

// Casts the rays with these numbers, first to end - 1: radius along each, mm, NaN where there is none.
// Several threads may cast at the same time.
struct RayRange {
  std::size_t first;  // number of the first ray
  std::size_t end;    // behind that of the last one
};
// Radius i of all `radii` is that of ray i; those out of the range stay as they are.
void cast_coherent(const EmbreeScene& scene, const RayDirections& directions, RayRange rays,
                   std::span<float> radii);

}  // namespace impinge::lab
