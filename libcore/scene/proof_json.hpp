// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about the gaps of a scene, for summary.json.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "joint/measurement.hpp"

namespace impinge {

const char* verdict_name(bool impinged);  // "impinged" or "clear"

/// What is proven about the gaps of all vertices: the largest bound, how many vertices have none, the
/// interval of the smallest gap, and how many vertices were measured on the faces because their bounds left
/// that open. null without bounds.
nlohmann::json bounds_json(const std::optional<PoseVerdicts>& proven);

/// Euclidean distances: the interval of the smallest, and how far the radial gaps are certain to exceed them.
/// null without distances.
nlohmann::json distances_json(const PoseAnswer& found);

/// Exact verdicts on bone on bone; null if not asked for.
nlohmann::json certificate_json(const std::optional<Certificate>& found);

}  // namespace impinge
