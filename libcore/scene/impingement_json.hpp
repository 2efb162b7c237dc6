// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface is close to the other one, as summary.json has it.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "hip/clock.hpp"
#include "scene/reported_surface.hpp"

namespace impinge {

/// How places of a scene are told: the centre in the input frame, mm; the dial of the socket in the joint
/// frame, if it has one; the rotation to that frame.
struct Whereabouts {
  Vec3 centre;                    // mm, input frame
  std::optional<ClockFace> dial;  // of the socket; none if it has none
  Eigen::Matrix3d axes;           // from the input frame to the joint frame
};

/// The dial as unit vectors of the joint frame; null if there is none.
nlohmann::json dial_json(const std::optional<ClockFace>& dial);

/// Vertices, area and stretches of the dial with a gap of up to the threshold: mm, or a share of a map's
/// thickness.
nlohmann::json impingement_json(const ReportedSurface& v, double threshold, const Whereabouts& where);

/// The vertex with the smallest gap; null if none has one.
nlohmann::json smallest_json(const ReportedSurface& v, const Whereabouts& where);

/// The first of the smaller of two of these.
nlohmann::json smaller(const nlohmann::json& a, const nlohmann::json& b);

/// Colours and where they end; `map` if those are shares of the thickness of a map.
nlohmann::json levels_json(const ReportedSurface& v, bool map);

/// Area by gap; null if the surface was not scanned.
nlohmann::json histogram_json(const ReportedSurface& v);

}  // namespace impinge
