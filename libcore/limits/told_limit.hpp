// SPDX-License-Identifier: GPL-3.0-or-later
// A limit with what its reader must know: the intervals for other centres, and whether half a millimetre
// changes it.
#pragma once

#include <optional>
#include <string>

#include "limits/turn_limit.hpp"

namespace impinge {

/// mm by which a scan and a segmentation may misplace the centre or a surface.
inline constexpr double kErrorOfInput = 0.5;
/// degrees: a smaller change of a limit does not count. Our choice: limitations of this size are what such
/// programs are expected to find (Roeling et al. 2015, doi:10.1186/s12891-015-0504-7).
inline constexpr double kOfNote = 5.0;

/// The limit of one motion about one centre.
struct ToldLimit {
  double threshold_mm = 0.0;  // 0: contact of bones; else the gap of a vertex
  TurnLimit limit;            // of the meshes as they are
  /// For every common centre within kErrorOfInput of the given one. Of a ball that reaches less than 2 mm
  /// from the centre nothing is told here, and of its play.
  CentreInterval common;
  CentreInterval play;  // for every play of the ball up to kErrorOfInput
  /// For contact only: the angle at which a vertex first has a gap of kErrorOfInput or less; nothing if no
  /// vertex has one up to the low end of the limit, as where edges touch and all vertices are farther away.
  std::optional<double> half_mm_gap_deg;

  /// Could an error of half a millimetre move the limit by more than kOfNote?
  bool hangs_on_less() const { return hangs_on_centre() || hangs_on_play(); }
  /// True if for some common centre within half a millimetre the limit may be that far off, a free or blocked
  /// motion included.
  bool hangs_on_centre() const;
  /// True if the gap was that small more than kOfNote before the limit, or was that small and there is no
  /// limit.
  bool hangs_on_play() const;
  /// Such as "sensitive to 0.5 mm of play"; empty if it is not.
  std::string sensitivity() const;
};

/// The first contact if the threshold is 0, the first gap of that many mm otherwise. Angles in degrees.
ToldLimit told_limit(const TurnLimits& limits, const JointTurn& turn, double threshold_mm,
                     double largest_deg);

}  // namespace impinge
