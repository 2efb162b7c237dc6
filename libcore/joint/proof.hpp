// SPDX-License-Identifier: GPL-3.0-or-later
// A proof about a pose or a motion of a session's joint that can be checked without this library
// (limits/clearance_proof.hpp). It is about the meshes as they lie in their files: there is no proof with
// landmarks, which turn the ball.
//
// It is about bodies: all surfaces of a side, parts and all.
#pragma once

#include <array>

#include "joint/limits.hpp"
#include "limits/clearance_proof.hpp"

namespace impinge {

/// The proof of a motion ends this many degrees before its limit: the first of these that leaves room to
/// prove.
inline constexpr std::array kProofEndsBefore{0.01, 0.1, 1.0};

/// Proves that a pose is clear, or that it is not. std::runtime_error with the reason, one line, if neither
/// can be proven.
ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose);

/// Proves that the motion is clear from its start to kProofEndsBefore before the lower end of its limit,
/// about the centre of the ball, which is not shifted. std::runtime_error as above.
ClearanceProof answer_proof(Session& session, const LimitRequest& request);

}  // namespace impinge
