// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/proof.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "files/formatted.hpp"
#include "motion/body_pairs.hpp"

namespace impinge {
namespace {

// A turn of the joint frame in that of the meshes.
JointTurn in_input_frame(const JointTurn& turn, const Eigen::Matrix3d& axes) {
  return {axes.transpose() * turn.outer * axes, axes.transpose() * turn.axis,
          axes.transpose() * turn.inner * axes};
}

// From the centre, of length 1.
Vec3 unproven_direction(const ClearanceProof& proof) {
  if (!proof.ray) return proof.open.value();
  const auto [x, y, z] = *proof.ray;
  return Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)).normalized();
}

[[noreturn]] void refuse(const ClearanceProof& proof, const std::string& what, const std::string& why) {
  const Vec3 u = unproven_direction(proof);
  throw std::runtime_error(what + formatted(", in the direction %.4f,%.4f,%.4f", u.x(), u.y(), u.z()) +
                           " from the centre" + why + "; the exact verdict on a pose decides there");
}

// Of the main surfaces.
void require_proven(const ClearanceProof& proof, const std::string& where) {
  if (proof.open)
    refuse(proof, where + "the surfaces are too near to each other to tell a gap from a contact", "");
}

// With parts, none of which is in contact.
void require_nearer(const ClearanceProof& proof, const std::string& where) {
  if (proof.open || proof.ray)
    refuse(proof, where + "the ball with its parts is not clearly nearer than the socket with its parts",
           ": they are not in contact, but a certificate needs this in every direction");
}

void require_no_contact(const Joint& joint, const Joint& main, const Pose& pose) {
  const BodyPairs bodies({main.ball.mesh, main.socket.mesh},
                         bone_parts({joint.ball.mesh, joint.ball.parts},
                                    {joint.socket.mesh, joint.socket.parts}));
  const auto found = bodies.nearest_part(pose);
  if (!found || !found->touch) return;
  const std::string ball = body_name(joint.ball.parts, found->pair.ball);
  const std::string socket = body_name(joint.socket.parts, found->pair.socket);
  throw std::runtime_error(
      (ball.empty() ? "the ball" : ball) + " is in contact with " + (socket.empty() ? "the socket" : socket) +
      ": a certificate of contact is a ray between the two main surfaces, and these are clear");
}

ClearanceProof prove_pose_of(const Joint& joint, const Pose& pose) {
  const BallSocketPair meshes{joint.ball.mesh, joint.socket.mesh};
  return prove_pose({meshes, joint.centre}, pose);
}

// The main surfaces are proven clear in the pose.
ClearanceProof prove_with_parts(const Joint& joint, const Joint& main, const Pose& pose) {
  ClearanceProof proof = prove_pose_of(joint, pose);
  require_no_contact(joint, main, {rotation_of(proof.outer), proof.shift});
  require_nearer(proof, "");
  return proof;
}

// The rest of a whole bone is in the file of its main surface.
std::array<std::size_t, 2> bodies_of(const Joint& joint) {
  const auto files = [](const JointPart& part) {
    return 1 + static_cast<std::size_t>(std::ranges::count(part.parts, false, &MeshPart::of_main));
  };
  return {files(joint.ball), files(joint.socket)};
}

}  // namespace

ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose) {
  const Joint main = without_parts(joint.joint);
  ClearanceProof proof = prove_pose_of(main, pose);
  require_proven(proof, "");
  if (joint.joint.has_parts() && !proof.ray) proof = prove_with_parts(joint.joint, main, pose);
  proof.bodies = bodies_of(joint.joint);
  return proof;
}

ClearanceProof answer_proof(Session& session, const LimitRequest& request) {
  const double last = answer_limits(session, request).contact.told.limit.low_deg - kProofEndsBefore;
  if (!(last > 0.0))
    throw std::runtime_error(
        formatted("the motion ends within %g degrees of its start; begin at another pose", kProofEndsBefore));
  const SessionJoint& joint = *session.joint;
  const BallSocketPair meshes{joint.joint.ball.mesh, joint.joint.socket.mesh};
  const JointTurn turn = joint_turn(request.start, motion_name(request.growing), joint.side);
  ClearanceProof proof = prove_turn({meshes, joint.joint.centre}, in_input_frame(turn, joint.axes), last);
  const std::string where = formatted("%.4f degrees along the motion ", proof.end_deg());
  if (joint.joint.has_parts())
    require_nearer(proof, where);
  else
    require_proven(proof, where);
  proof.bodies = bodies_of(joint.joint);
  return proof;
}

}  // namespace impinge
