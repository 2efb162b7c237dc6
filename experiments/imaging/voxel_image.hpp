// SPDX-License-Identifier: GPL-3.0-or-later
// An image of voxels, such as CT gives: slices one above the other along +z.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sphere/direction.hpp"

namespace impinge {

struct VoxelImage {
  std::array<std::size_t, 3> count{};  // voxels along x, y, z
  Vec3 spacing = Vec3::Ones();         // mm between middles: pixel, pixel, slice distance
  Vec3 origin = Vec3::Zero();          // mm, middle of voxel (0, 0, 0)
  std::vector<float> values;           // x fastest, then y, then z

  /// Place of voxel (i, j, k) among the values.
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return (k * count[1] + j) * count[0] + i;
  }
  std::size_t size() const { return count[0] * count[1] * count[2]; }  // number of voxels
};

}  // namespace impinge
