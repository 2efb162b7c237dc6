// SPDX-License-Identifier: GPL-3.0-or-later
// The file of --certificate: a proof that needs none of this program.
#pragma once

#include <string>

#include "scene/options.hpp"
#include "session/proof.hpp"

namespace impinge {

/// Of the pose, or where a limit is asked for of the way to it (session/proof.hpp). std::runtime_error, one
/// line, where nothing can be proven.
ClearanceProof proof_asked(Session& session, const SceneOptions& options);

/// What the file holds, for a reader at a terminal.
std::string describe_proof(const SceneOptions& options, const ClearanceProof& proof);

}  // namespace impinge
