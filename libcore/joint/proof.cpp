// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/proof.hpp"

#include <stdexcept>

#include "files/formatted.hpp"
#include "joint/document.hpp"

namespace impinge {
namespace {

// A turn of the joint frame, expressed in the frame of the meshes.
JointTurn in_input_frame(const JointTurn& turn, const Eigen::Matrix3d& axes) {
  return {axes.transpose() * turn.outer * axes, axes.transpose() * turn.axis,
          axes.transpose() * turn.inner * axes};
}

void require_proven(const ClearanceProof& proof, const std::string& when) {
  if (proof.says == ClearanceProof::Says::unknown)
    throw std::runtime_error("no surfaces meet, but a bone is open, and no closed one tells what is inside");
  if (proof.says != ClearanceProof::Says::open) return;
  const Vec3& x = proof.place;
  throw std::runtime_error(
      when +
      formatted("the surfaces are too near to each other to tell a gap from a contact, %.2f,%.2f,%.2f mm "
                "from the centre; the exact verdict on a pose decides there",
                x.x(), x.y(), x.z()));
}

// Numbers of files. The rest of a whole bone is in the file of its main surface.
std::array<std::size_t, 2> files_of(const Joint& joint) {
  const auto files = [](const JointPart& part) { return 1 + part.parts.size() - (part.taken ? 1 : 0); };
  return {files(joint.ball), files(joint.socket)};
}

// Index of a face in its file; the faces of a whole bone were put in another order.
std::uint32_t given_face(const JointPart& part, std::uint32_t face) {
  return part.taken && face < part.taken->of ? part.taken->given[face] : face;
}

}  // namespace

ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose) {
  // As they lie in the files; those of a session may be shifted.
  const BallSocketPair meshes{joint.joint.ball.mesh, joint.joint.socket.mesh};
  const BodyPairs bodies(joint.joint.main(), joint.joint.beside());
  ClearanceProof proof = prove_pose({meshes, bodies, joint.joint.centre}, pose);
  require_proven(proof, "");
  proof.faces = {given_face(joint.joint.ball, proof.faces[0]),
                 given_face(joint.joint.socket, proof.faces[1])};
  proof.files = files_of(joint.joint);
  return proof;
}

ClearanceProof answer_proof(Session& session, const LimitRequest& request) {
  const double limit = answer_limits(session, request).front().told.limit.low_deg;
  if (!(limit > kProofEndsBefore[0]))
    throw std::runtime_error(formatted(
        "the motion ends within %g degrees of its start; begin at another pose", kProofEndsBefore[0]));
  const SessionJoint& joint = *session.joint;
  const BallSocketPair meshes{joint.joint.ball.mesh, joint.joint.socket.mesh};
  const JointTurn turn =
      in_input_frame(joint_turn(request.start, motion_name(request.growing), joint.side), joint.axes);
  const BodyPairs bodies(joint.joint.main(), joint.joint.beside());
  ClearanceProof proof;
  for (const double before : kProofEndsBefore) {
    if (!(limit > before)) break;
    proof = prove_turn({meshes, bodies, joint.joint.centre}, turn, limit - before);
    if (proof.says == ClearanceProof::Says::inside)
      throw std::runtime_error("the motion begins in contact: a point of one body is inside the other");
    if (proof.says != ClearanceProof::Says::open) break;
  }
  require_proven(proof, formatted("%.4f degrees along the motion ", proof.open_deg));
  proof.files = files_of(joint.joint);
  return proof;
}

void CertifyRequest::check() const {
  if (motion) in_field("motion", [this] { motion_name(*motion); });
}

CertifyAnswer answer(Session& session, const CertifyRequest& request) {
  const Joint& joint = session.joint->joint;
  if (joint.frames)
    throw std::invalid_argument(
        "landmarks: a certificate is about the meshes as they lie in their files; leave them out");
  if (joint.overlap_mm > 0.0)
    throw std::invalid_argument("overlap_mm: a certificate is about the meshes as they are; leave it out");
  const Motion pose = request.pose.value_or(Motion());
  try {
    const ClearanceProof proof =
        request.motion ? answer_proof(session, LimitRequest{.start = pose, .growing = *request.motion})
                       : answer_proof(*session.joint, pose_of(*session.joint, pose));
    constexpr std::array<const char*, 3> kSays{"clear", "crossing", "inside"};
    CertifyAnswer found{kSays.at(static_cast<std::size_t>(proof.says)),
                        {},
                        proof.closed,
                        proof.rounded_deg,
                        proof_text(proof)};
    if (request.motion) found.to_deg = degrees_of(proof.last);
    return found;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("no certificate: ") + error.what());
  }
}

}  // namespace impinge
