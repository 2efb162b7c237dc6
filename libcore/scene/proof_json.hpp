// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about the gaps of a scene, as summary.json has it.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "session/measurement.hpp"

namespace impinge {

const char* name(OverlayKind kind);       // of a contact, as in "ball vertex"
const char* verdict_name(bool impinged);  // "impinged" or "clear"

/// What is proven about the gaps of all vertices: the largest bound; how many have none from the table; and
/// where the smallest gap is, of those whose bound leaves that open measured on the faces. null without
/// bounds.
nlohmann::json bounds_json(const std::optional<PoseVerdicts>& proven);

/// Gaps are radial. Where one is above the upper end of the Euclidean distance it overstates it for certain.
/// null without distances.
nlohmann::json distances_json(const PoseAnswer& found);

/// What is certain about bone on bone; null where it was not asked for.
nlohmann::json certificate_json(const std::optional<Certificate>& found);

}  // namespace impinge
