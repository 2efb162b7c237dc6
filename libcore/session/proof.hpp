// SPDX-License-Identifier: GPL-3.0-or-later
// A proof about a pose or a motion of a session's joint that can be checked without this library
// (motion/clearance_proof.hpp). It is about the meshes as they lie in their files: there is no proof with
// landmarks, which turn the ball.
//
// Bone beside the joint. A clear proof is about all surfaces of a side: in every direction all of the ball
// and its parts is nearer than all of the socket and its parts, so that no two of them meet. That is more
// than to be free: a trochanter may pass behind the rim, or the shaft behind a spine, and then there is no
// proof. A ray shows contact of the main surfaces alone, since a part that lies farther out along a ray need
// not touch (motion/body_pairs.hpp): so contact of a part has no proof. A part inside other bone touches it
// although no surfaces meet, beyond the end of a ball's mesh for one. There the exact verdict comes first,
// and nothing is written.
#pragma once

#include "motion/clearance_proof.hpp"
#include "session/limits.hpp"

namespace impinge {

/// The proof of a motion ends this many degrees before its limit.
inline constexpr double kProofEndsBefore = 0.1;

/// Proves that a pose is clear, or gives a ray that shows contact of the main surfaces. std::runtime_error
/// with the reason, one line, if neither can be proven.
ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose);

/// Proves that the motion is clear from its start to kProofEndsBefore before the lower end of its limit,
/// about the centre of the ball, which is not shifted. std::runtime_error as above.
ClearanceProof answer_proof(Session& session, const LimitRequest& request);

}  // namespace impinge
