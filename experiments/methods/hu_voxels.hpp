// SPDX-License-Identifier: GPL-3.0-or-later
// Method hu_voxels: the impingement detection of Hu et al. (2001), which Kubiak-Langer et al. (2007) used for
// their ranges of motion, as the thesis describes it (Section 2.4, Eq. 1-4). The socket's voxels are marked
// in a table with a byte for each of the n^3 voxels of its box; the middle of each voxel of the ball is moved
// and looked up; where it finds a mark, it is a collided point. No distance is known.
//
// Voxels are those that a face meets: the socket of a joint is an open surface and has no inside. Proven: at
// a hit the surfaces are at most 3/2 sqrt(3) h apart, h the side of a voxel. The middle of a ball's voxel is
// within sqrt(3)/2 h of the ball's surface, and a point of a marked voxel within sqrt(3) h of the socket's. A
// contact is missed if no middle falls into a marked voxel.
#pragma once

#include <numbers>
#include <vector>

#include "gap/pose.hpp"
#include "methods/voxel_table.hpp"

namespace impinge::lab {

// Largest distance of the surfaces where a voxel is hit, in sides of a voxel.
inline constexpr double kVoxelReach = 1.5 * std::numbers::sqrt3;

class HuVoxels {
 public:
  // Meshes in their centre frames, mm; size is the side of a voxel, mm. Throws as surface_voxels() does.
  HuVoxels(const TriangleMesh& ball, const TriangleMesh& socket, double size);

  // All voxels of the ball are looked up, as the method reports each collided point.
  bool touches(const Pose& pose) { return !collided(pose).empty(); }

  // Middles of the ball's voxels that hit, in the socket's frame, mm.
  const std::vector<Vec3>& collided(const Pose& pose);

  const VoxelTable& table() const { return socket_; }       // of the socket
  std::size_t ball_voxels() const { return ball_.size(); }  // number of voxels that are looked up
  // Of the table and of the ball's voxels.
  std::size_t bytes() const { return socket_.occupied.size() + ball_.size() * sizeof(Vec3); }

 private:
  std::vector<Vec3> ball_;  // middles of voxels, ball frame
  VoxelTable socket_;
  std::vector<Vec3> collided_;
};

}  // namespace impinge::lab
