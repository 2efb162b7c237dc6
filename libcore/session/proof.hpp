// SPDX-License-Identifier: GPL-3.0-or-later
// A proof of a pose or a motion of a session's joint that needs none of this library
// (motion/clearance_proof.hpp). It is of the meshes as they lie in their files: landmarks, which turn the
// ball, have none.
#pragma once

#include "motion/clearance_proof.hpp"
#include "session/limits.hpp"

namespace impinge {

/// Before the limit of a motion, degrees: where the proof of the way to it ends.
inline constexpr double kProofEndsBefore = 0.1;

/// Of the pose: that it is clear, or a ray that shows contact. std::runtime_error with the reason, one line,
/// where neither can be proven.
ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose);

/// Of the way from the start to kProofEndsBefore before the lower end of the limit, about the centre of the
/// ball, which is not shifted. std::runtime_error as above.
ClearanceProof answer_proof(Session& session, const LimitRequest& request);

}  // namespace impinge
