// SPDX-License-Identifier: GPL-3.0-or-later
// Positions round the socket as on the face of a clock: 12 superior, 3 anterior on both sides of the body.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// The dial, in the joint frame: unit vectors in the plane perpendicular to the axis of the socket.
struct ClockFace {
  Vec3 twelve = Vec3::UnitZ();  // unit vector towards 12 o'clock
  Vec3 three = Vec3::UnitY();   // unit vector towards 3 o'clock

  /// Hours in [0, 12) of a direction that is not along the axis of the socket.
  double hours(const Vec3& direction) const;
};

/// The dial about an axis (a unit vector, joint frame). None if the axis is vertical (no side of the dial is
/// superior) or points straight forward or back (none is anterior).
std::optional<ClockFace> clock_about(const Vec3& axis);

/// The dial of a socket (joint frame, centre as origin), about the area-weighted mean direction of the
/// surface. None as for clock_about(), or if the mean vanishes.
std::optional<ClockFace> clock_face(const TriangleMesh& socket);

/// A stretch of the dial, from `from` clockwise to `to`, hours in [0, 12).
struct ClockZone {
  double from = 0.0;  // hours
  double to = 0.0;    // hours; less than `from` where the stretch passes 12 o'clock
  double area = 0.0;  // mm^2
};

/// Groups points at `hours`, each with its `area` (mm^2, same size), into stretches of the dial, the largest
/// area first. They are resolved to a quarter of an hour, and gaps of one quarter are bridged. A full turn is
/// one zone from 0 to 0.
std::vector<ClockZone> clock_zones(std::span<const double> hours, std::span<const double> area);

/// "1:30" for 1.5; 0 is "12:00".
std::string clock_text(double hours);
inline std::optional<std::string> clock_text(const std::optional<double>& hours) {
  return hours ? std::optional(clock_text(*hours)) : std::nullopt;
}

}  // namespace impinge
