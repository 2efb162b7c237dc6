// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/hu_voxels.hpp"

namespace impinge::lab {

HuVoxels::HuVoxels(const TriangleMesh& ball, const TriangleMesh& socket, double size)
    : socket_(make_voxel_table(surface_voxels(socket, size), size)) {
  for (const Voxel& voxel : surface_voxels(ball, size)) ball_.push_back(centre_of(voxel, size));
}

const std::vector<Vec3>& HuVoxels::collided(const Pose& pose) {
  collided_.clear();
  for (const Vec3& middle : ball_) {
    const Vec3 x = to_socket(pose, middle);
    if (socket_.holds(voxel_at(x, socket_.box.size))) collided_.push_back(x);
  }
  return collided_;
}

}  // namespace impinge::lab
