// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/proof.hpp"

#include <stdexcept>
#include <string>

#include "gap/formatted.hpp"

namespace impinge {
namespace {

// A turn of the joint frame in that of the meshes.
JointTurn in_input_frame(const JointTurn& turn, const Eigen::Matrix3d& axes) {
  return {axes.transpose() * turn.outer * axes, axes.transpose() * turn.axis,
          axes.transpose() * turn.inner * axes};
}

void require_proven(const ClearanceProof& proof, const std::string& where) {
  if (!proof.open) return;
  const Vec3& u = *proof.open;
  throw std::runtime_error(
      where + "the surfaces are too near to each other to tell a gap from a contact, in the direction " +
      formatted("%.4f,%.4f,%.4f", u.x(), u.y(), u.z()) +
      " from the centre; the exact verdict on a pose decides there");
}

}  // namespace

ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose) {
  require_no_parts(joint.joint, "certificate");
  const BallSocketPair meshes{joint.joint.ball.mesh, joint.joint.socket.mesh};
  ClearanceProof proof = prove_pose({meshes, joint.joint.centre}, pose);
  require_proven(proof, "");
  return proof;
}

ClearanceProof answer_proof(Session& session, const LimitRequest& request) {
  require_no_parts(session.joint->joint, "certificate");
  const double last = answer_limits(session, request).contact.told.limit.low_deg - kProofEndsBefore;
  if (!(last > 0.0))
    throw std::runtime_error(
        formatted("the motion ends within %g degrees of its start; begin at another pose", kProofEndsBefore));
  const SessionJoint& joint = *session.joint;
  const BallSocketPair meshes{joint.joint.ball.mesh, joint.joint.socket.mesh};
  const JointTurn turn = joint_turn(request.start, motion_name(request.growing), joint.side);
  ClearanceProof proof = prove_turn({meshes, joint.joint.centre}, in_input_frame(turn, joint.axes), last);
  require_proven(proof, formatted("%.4f degrees along the motion ", proof.end_deg()));
  return proof;
}

}  // namespace impinge
