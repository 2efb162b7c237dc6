// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "17_limit_time/limit_times.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/joint.hpp"
#include "mesh/io.hpp"
#include "phantoms/phantom.hpp"

namespace impinge::lab {
namespace {

constexpr const char* kFemur = "femur.ply";
constexpr const char* kPelvis = "pelvis.ply";

TurnedJoint as_given(std::string name, BallSocketPair bones, Side side) {
  return {std::move(name), bones, bones, {}, side};
}

TriangleMesh turned_to(const Eigen::Matrix3d& axes, TriangleMesh mesh) {
  for (Vec3& x : mesh.vertices) x = axes * x;
  return mesh;
}

// Prepares whole bones as the program does.
TurnedJoint whole_joint(const RealJoint& described, const std::filesystem::path& folder) {
  JointInput input;
  input.ball = {kFemur, read_mesh(folder / kFemur)};
  input.socket = {kPelvis, read_mesh(folder / kPelvis)};
  input.side = described.side;
  input.axes = described.axes;
  Joint joint = assemble_joint(std::move(input));
  const Eigen::Matrix3d axes = input_to_joint(described.axes);
  TurnedJoint whole{described.subject, {}, {}, {}, described.side};
  const TriangleMesh ball = turned_to(axes, std::move(joint.ball.mesh));
  const TriangleMesh socket = turned_to(axes, std::move(joint.socket.mesh));
  whole.bones = {whole_main(ball, joint.ball.parts), whole_main(socket, joint.socket.parts)};
  whole.main = {main_surface(ball, joint.ball.parts), main_surface(socket, joint.socket.parts)};
  whole.beside = bone_parts({ball, joint.ball.parts}, {socket, joint.socket.parts});
  return whole;
}

}  // namespace

TurnedJoint generated_hip(std::size_t faces) {
  const HipParameters parameters = hip_preset("normal");
  return as_given("normal hip, cropped", main_surfaces(make_hip(parameters, faces / 2)), parameters.side);
}

TurnedJoint replaced_hip(std::size_t faces) { return as_given("implant", make_implant(faces), Side::right); }

std::vector<TurnedJoint> whole_joints(const std::filesystem::path& folder, Progress& progress) {
  std::vector<TurnedJoint> joints;
  for (const RealJoint& joint : read_real_joints(folder, progress)) {
    const std::filesystem::path files = folder / joint.subject;
    if (exists(files / kFemur) && exists(files / kPelvis)) joints.push_back(whole_joint(joint, files));
  }
  return joints;
}

}  // namespace impinge::lab
