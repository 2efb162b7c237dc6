// SPDX-License-Identifier: GPL-3.0-or-later
// Proves something about a pose or a motion of a session's joint that can be checked without this library
// (limits/clearance_proof.hpp). The proof is about all surfaces of each side, parts included, as they lie in
// their files. With landmarks, which turn the ball, there is no proof.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "files/fields.hpp"
#include "joint/limits.hpp"
#include "joint/touch.hpp"
#include "limits/clearance_proof.hpp"

namespace impinge {

/// The proof of a motion ends this many degrees before its limit: the first value that leaves room to prove.
inline constexpr std::array kProofEndsBefore{0.01, 0.1, 1.0};

/// Proves that a pose is clear, or that it is not. Throws std::runtime_error with the reason, one line, if
/// neither can be proven.
ClearanceProof answer_proof(const SessionJoint& joint, const Pose& pose);

/// Proves that the motion is clear from its start to kProofEndsBefore before the lower end of its limit. The
/// motion is about the centre of the ball, without a shift. Throws std::runtime_error as above.
ClearanceProof answer_proof(Session& session, const LimitRequest& request);

struct CertifyRequest {
  std::optional<Motion> pose;
  std::optional<std::string> motion;

  static constexpr std::tuple fields{
      Field{"pose", "", "that is proven, or that the motion begins at [all angles 0]", &CertifyRequest::pose},
      Field{"motion", "",
            "prove the way from the pose to the limit of this motion, as flexion [none: the pose alone]",
            &CertifyRequest::motion}};
  void check() const;
};

struct CertifyAnswer {
  std::string says;
  std::optional<double> to_deg;
  bool closed = false;
  double rounded_deg = 0.0;
  std::string text;  // the certificate as text

  static constexpr std::tuple fields{
      Field{"says", "",
            "clear: the surfaces do not meet; crossing: they do; inside: one body is inside the other",
            &CertifyAnswer::says},
      Field{"to_deg", "deg", "how far along the motion that is proven; null for a pose",
            &CertifyAnswer::to_deg},
      Field{"closed", "", "have all bodies no opening? What is open has no inside", &CertifyAnswer::closed},
      Field{"rounded_deg", "deg", "by how much the rotations differ from those asked for, at most",
            &CertifyAnswer::rounded_deg}};
};

/// Throws std::runtime_error, one line, where nothing can be proven; std::invalid_argument where the joint is
/// not as in its files, because of landmarks or an overlap.
CertifyAnswer answer(Session& session, const CertifyRequest& request);

}  // namespace impinge
