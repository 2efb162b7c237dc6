// SPDX-License-Identifier: GPL-3.0-or-later
// The file of --certificate: a proof that can be checked without this program.
#pragma once

#include <string>

#include "joint/proof.hpp"
#include "scene/options.hpp"

namespace impinge {

/// The proof for the pose or, if a limit is asked for, for the motion up to it (joint/proof.hpp).
/// std::runtime_error, one line, if nothing can be proven.
ClearanceProof proof_asked(Session& session, const SceneOptions& options);

/// What the file holds, as text for a terminal.
std::string describe_proof(const SceneOptions& options, const ClearanceProof& proof);

}  // namespace impinge
