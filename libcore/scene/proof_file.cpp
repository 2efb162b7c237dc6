// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/proof_file.hpp"

#include <stdexcept>

#include "files/formatted.hpp"
#include "scene/limit.hpp"

namespace impinge {

ClearanceProof proof_asked(Session& session, const SceneOptions& options) {
  try {
    return options.limit == nullptr ? answer_proof(*session.joint, pose_of(*session.joint, options.motion))
                                    : answer_proof(session, limit_request(options));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("option --certificate: no certificate for " + options.certificate->string() +
                             ", " + error.what());
  }
}

std::string describe_proof(const SceneOptions& options, const ClearanceProof& proof) {
  std::string text = "certificate         ";
  if (proof.says == ClearanceProof::Says::crossing) {
    text += "contact, surfaces cross";
  } else if (proof.says == ClearanceProof::Says::inside) {
    text += "contact, one body is inside the other";
  } else {
    text += proof.closed ? "no contact" : "surfaces do not meet";
    if (options.limit != nullptr)
      text += " from 0 to " + rounded_down(degrees_of(proof.last), 4) + " degrees";
    if (!proof.closed) text += ", and nothing is inside what is closed";
  }
  return text + formatted("; rotations rounded by %.1g degrees: ", proof.rounded_deg) +
         options.certificate->string() + "\n";
}

}  // namespace impinge
