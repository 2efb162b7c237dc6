// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the faces of a mesh into blocks; see exact_cells.hpp.
#pragma once

#include "gap/simd/exact_cells.hpp"
#include "gap/simd/seen_planes.hpp"

namespace impinge {

/// A face as a lane of a block.
struct FaceLane {
  std::array<Eigen::Vector3f, 3> edge;  // see FaceBlock
  Eigen::Vector3f plane;
};
std::vector<FaceLane> face_lanes(const SeenMesh& seen, Layer layer);  // of all faces

/// The block of one to eight of these faces.
FaceBlock face_block(std::span<const FaceLane> all, std::span<const std::uint32_t> faces);

}  // namespace impinge
