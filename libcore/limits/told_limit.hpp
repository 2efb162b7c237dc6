// SPDX-License-Identifier: GPL-3.0-or-later
// A limit with what its reader must know: the interval for other centres, and whether half a millimetre
// changes it.
#pragma once

#include <optional>

#include "limits/turn_limit.hpp"

namespace impinge {

/// mm, of the centre or the surface: what a scan and a segmentation leave unknown.
inline constexpr double kErrorOfInput = 0.5;

/// The limit of one motion about one centre.
struct ToldLimit {
  double threshold_mm = 0.0;  // 0: contact of the surfaces; else the gap of a vertex
  TurnLimit limit;            // of the meshes as they are
  CentreInterval common;      // for every common centre within kErrorOfInput of theirs
  CentreInterval play;        // for every play of the ball of up to that
  /// For contact only: the angle at which a vertex first has a gap of kErrorOfInput or less; nothing where
  /// none has one up to the low end of the limit, as where edges touch between vertices that are farther
  /// away.
  std::optional<double> half_mm_gap_deg;

  /// Does the limit depend on less than half a millimetre: was the gap that small more than 5 degrees before
  /// the limit, or is there no limit although it was; or may the limit of a centre within that, also of what
  /// is free or blocked here, be more than 5 degrees off? The 5 degrees are our choice: a limitation of that
  /// size is what such programs are held to find (Roeling et al. 2015, doi:10.1186/s12891-015-0504-7).
  bool hangs_on_less() const;
};

/// The first contact if the threshold is 0, the first gap of that many mm otherwise. Angles in degrees.
ToldLimit told_limit(const TurnLimits& limits, const JointTurn& turn, double threshold_mm,
                     double largest_deg);

}  // namespace impinge
