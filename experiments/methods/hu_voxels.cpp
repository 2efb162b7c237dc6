// SPDX-License-Identifier: GPL-3.0-or-later
// @can     baseline
// @links   gap voxel_table reference

#include "methods/hu_voxels.hpp"

#include <algorithm>
#include <memory>

#include "files/csv.hpp"
#include "methods/baseline.hpp"
#include "reference/closest_point.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kChecked = 50;  // hits that are checked, at most

// Checks that each hit is in a voxel of the socket.
void check(HuVoxels& voxels, const BallSocketPair& joint, double size) {
  Pose deep;  // a pose with hits
  deep.translation = Vec3(0.0, 0.0, 5.0);
  const std::vector<Vec3>& all = voxels.collided(deep);
  std::vector<Vec3> hits;
  for (std::size_t i = 0; i < all.size(); i += all.size() / kChecked + 1) hits.push_back(all[i]);
  const auto apart = closest_distances(joint.socket, {hits});
  if (std::ranges::any_of(apart, [size](double d) { return d > std::numbers::sqrt3 * size; }))
    broken("hu_voxels", "a collided point is farther from the socket than the voxel is wide");
}

BaselineCase with_voxels(const BallSocketPair& joint, double size) {
  const auto voxels = std::make_shared<HuVoxels>(joint.ball, joint.socket, size);
  check(*voxels, joint, size);
  BaselineCase one;
  one.setting = Cell(size).text() + " mm";
  one.place = 0;
  one.size = size;
  one.bytes = static_cast<double>(voxels->bytes());
  one.touches = [voxels](const Pose& pose) { return voxels->touches(pose); };
  one.build = [&joint, size] { HuVoxels(joint.ball, joint.socket, size); };
  return one;
}

}  // namespace

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

Method hu_voxels_method() {
  Method method{.name = "hu_voxels", .label = "Voxels (Hu)"};
  method.lacks = "distances: a voxel is hit or not";
  method.baseline = [](const BallSocketPair& joint, const BaselineSizes& sizes) {
    std::vector<BaselineCase> cases;
    for (const double size : sizes.voxels_mm) cases.push_back(with_voxels(joint, size));
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
