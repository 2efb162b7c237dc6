// SPDX-License-Identifier: GPL-3.0-or-later
// Lines through the voxels of an image, and where they cross a surface.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "imaging/voxel_image.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

inline constexpr double kLineSpacing = 0.25;  // mm, at most

/// Lines along x through the voxels, on a regular grid in y and z that is finer than the voxels.
struct ScanLines {
  std::array<std::size_t, 2> per_voxel{};  // lines along its sides in y and in z
  std::array<std::size_t, 2> count{};      // of lines along y and along z
  std::array<double, 2> first{};           // y and z of line (0, 0), mm
  std::array<double, 2> spacing{};         // mm

  /// Place of line i along y (axis 0) or z (axis 1), mm.
  double at(std::size_t axis, std::size_t i) const {
    return first[axis] + spacing[axis] * static_cast<double>(i);
  }
};

/// Where a line crosses the surface.
struct LineCrossing {
  double x;  // mm
  int step;  // +1 into the body, -1 out of it
};

/// Two lines or more along each side of a voxel.
ScanLines lines_of(const VoxelImage& image);

/// Crossings of every line, lines with y fastest, the crossings of a line in no order. A line that meets an
/// edge or a vertex is treated as if it passed just beside it.
std::vector<std::vector<LineCrossing>> cross_all(const ScanLines& lines, const TriangleMesh& body);

}  // namespace impinge
