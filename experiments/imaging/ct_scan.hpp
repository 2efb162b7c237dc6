// SPDX-License-Identifier: GPL-3.0-or-later
// A synthetic CT scan of a bone: a homogeneous body, as a scanner without blur would show it. The brightness
// of a voxel is the share of it that the body fills (partial volume); there is no space between slices. The
// share is measured with lines along x, at most kLineSpacing (ct_scan.cpp) and half a voxel apart; each line
// is cut exactly with the surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// An image of voxels, such as CT gives: slices one above the other along +z.
struct VoxelImage {
  std::array<std::size_t, 3> count{};  // voxels along x, y, z
  Vec3 spacing = Vec3::Ones();         // mm between middles: pixel, pixel, slice distance
  Vec3 origin = Vec3::Zero();          // mm, middle of voxel (0, 0, 0)
  std::vector<float> values;           // values with x fastest, then y, then z

  /// Index of voxel (i, j, k) in the values.
  std::size_t index(std::size_t i, std::size_t j, std::size_t k) const {
    return (k * count[1] + j) * count[0] + i;
  }
  std::size_t size() const { return count[0] * count[1] * count[2]; }  // number of voxels
};

/// Resolution of a scanner.
struct ScanGrid {
  double pixel = 0.7;   // mm; 360 mm in 512 pixels
  double slice = 1.25;  // mm, distance and thickness (thesis, Section 3.5.2)
  double margin = 3.0;  // least width of soft tissue round the body, mm
};

/// The share of each voxel that the body fills, in [0, 1]. The mesh must be closed with outward normals, mm.
/// Throws std::invalid_argument if it is found not to be so, and for a grid of no voxels or more than 2^28.
VoxelImage bone_shares(const TriangleMesh& body, const ScanGrid& grid);

/// Hounsfield units: tissue + share (bone - tissue) + Gaussian noise, which is drawn voxel by voxel.
struct ScanLevels {
  double tissue = 50.0;    // mean outside of bone
  double bone = 850.0;     // mean inside of bone
  double noise = 25.0;     // standard deviation
  std::uint64_t seed = 0;  // of the noise

  /// Half-way between tissue and bone: the level at which a segmentation puts the surface.
  double threshold() const { return 0.5 * (tissue + bone); }
};
/// The image (Hounsfield units) for the shares from bone_shares().
VoxelImage hounsfield(const VoxelImage& shares, const ScanLevels& levels);

}  // namespace impinge
