// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/real_joints.hpp"

#include <stdexcept>

#include "hip/sphere_fit.hpp"
#include "joint/joint_folder.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"

namespace impinge::lab {
namespace {

Vec3 fitted_centre(const TriangleMesh& ball, const std::filesystem::path& file) {
  try {
    return fit_ball(ball).centre;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file.string() + ": " + error.what() + "; give the centre in subject.json");
  }
}

}  // namespace

std::vector<RealJoint> read_real_joints(const std::filesystem::path& folder, Progress& progress) {
  const JointFolders found = find_joints(folder);
  for (const std::string& reason : found.left_out) progress.say("left out: " + reason);
  std::vector<RealJoint> joints;
  for (const JointFolder& at : found.joints) {
    const TriangleMesh ball = read_mesh(at.ball);
    const Vec3 centre = at.centre ? *at.centre : fitted_centre(ball, at.ball);
    joints.push_back({at.subject,
                      {relative_to(ball, centre), relative_to(read_mesh(at.socket), centre)},
                      centre,
                      at.centre.has_value(),
                      at.radius,
                      at.side,
                      agreed_axes_of({at.ball, at.socket}, at.axes, "\"axes\"").code});
  }
  return joints;
}

BallSocketPair in_joint_frame(const RealJoint& joint) {
  const Eigen::Matrix3d axes = input_to_joint(joint.axes);
  BallSocketPair meshes = joint.meshes;
  for (TriangleMesh* mesh : {&meshes.ball, &meshes.socket}) {
    for (Vec3& x : mesh->vertices) x = axes * x;
  }
  return meshes;
}

}  // namespace impinge::lab
