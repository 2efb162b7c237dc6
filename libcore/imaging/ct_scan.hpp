// SPDX-License-Identifier: GPL-3.0-or-later
// A synthetic CT scan of a bone: what a scanner without blur would give of a homogeneous body.
//
// A voxel is as bright as the share of it that the body fills (partial volume), and slices are as thick as
// they are far apart. Along x the share is exact: each of a bundle of parallel lines is cut with the surface.
// Across, the lines are at most kLineSpacing (scan_lines.hpp) apart and pixel / 2.
#pragma once

#include <cstdint>

#include "imaging/voxel_image.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// How fine a scanner sees.
struct ScanGrid {
  double pixel = 0.7;   // mm; 360 mm in 512 pixels
  double slice = 1.25;  // mm, distance and thickness (thesis, Section 3.5.2)
  double margin = 3.0;  // mm of soft tissue round the body, at least; a voxel more is added
};

/// Shares in [0, 1]. The mesh is closed and has outward normals, mm; std::invalid_argument where a line
/// leaves it another time than it enters it, and for a grid of no voxels or more than 2^28.
VoxelImage bone_shares(const TriangleMesh& body, const ScanGrid& grid);

/// Hounsfield units: tissue + share (bone - tissue) + Gaussian noise, the seed's own for every voxel in turn.
struct ScanLevels {
  double tissue = 50.0;    // mean outside of bone
  double bone = 850.0;     // mean inside of bone
  double noise = 25.0;     // standard deviation
  std::uint64_t seed = 0;  // of the noise

  /// Half-way: where a segmentation sees the surface.
  double threshold() const { return 0.5 * (tissue + bone); }
};
/// The image that a scanner gives of such shares.
VoxelImage hounsfield(const VoxelImage& shares, const ScanLevels& levels);

}  // namespace impinge
