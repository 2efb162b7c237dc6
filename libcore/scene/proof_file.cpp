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
  const char* said = proof.ray                  ? "contact, along a ray"
                     : options.limit == nullptr ? "no contact in this pose"
                                                : "no contact on the way";
  std::string text = std::string("certificate         ") + said;
  if (!proof.ray && options.limit != nullptr)
    text += " from 0 to " + rounded_down(proof.end_deg(), 4) +
            formatted(" degrees, %zu cells", proof.cells.size());
  if (!proof.ray) text += formatted(", %zu leaves", proof.leaves());
  return text + formatted("; rotations rounded by %.1g degrees: ", proof.rounded_deg) +
         options.certificate->string() + "\n";
}

}  // namespace impinge
