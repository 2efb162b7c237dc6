// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about the gaps of a scene, as summary.json has it.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "scene/certificate.hpp"
#include "scene/reported_surface.hpp"

namespace impinge {

/// What is proven about the gaps of all vertices: the largest bound; how many have none from the table; and
/// where the smallest gap is, of those whose bound leaves that open measured on the faces. null without
/// bounds.
nlohmann::json bounds_json(const ReportedSurface& ball, const ReportedSurface& socket,
                           const SmallestBetween& smallest);

/// Gaps are radial. Where one is above the upper end of the Euclidean distance it overstates it for certain.
/// null without distances.
nlohmann::json distances_json(const ReportedSurface& ball, const ReportedSurface& socket);

/// What is certain about bone on bone; null where it was not asked for.
nlohmann::json certificate_json(const std::optional<Certificate>& found);

}  // namespace impinge
