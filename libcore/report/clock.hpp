// SPDX-License-Identifier: GPL-3.0-or-later
// Unrolls the gaps of the socket: the rim's clock hours go across, the angle from the socket's axis goes up.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "files/csv.hpp"
#include "joint/gaps.hpp"

namespace impinge {

/// A grid of directions from the centre of rotation; row 0 is nearest to the axis.
struct ClockMap {
  static constexpr std::size_t kColumns = 144;  // of five minutes each
  static constexpr double kRowDeg = 3.0;        // height of a row
  static constexpr double kAbsent = std::numeric_limits<double>::infinity();

  /// Angle of a row's middle from the axis, degrees.
  static double angle_deg(std::size_t row) { return kRowDeg * (static_cast<double>(row) + 0.5); }
  /// The hour of a column's middle.
  static double hours(std::size_t column) { return (static_cast<double>(column) + 0.5) * 12.0 / kColumns; }

  std::size_t rows = 0;
  /// By row, then column: mm; NaN where the socket faces no ball, kAbsent where there is no socket.
  std::vector<double> gap_mm;
  std::vector<double> against_cartilage;  // the same gaps, as gap_colour() takes them
  double touching = 0.0;                  // value in against_cartilage at which the layers touch
};

/// None without a dial. Gaps are linear between vertices; of several layers the smallest gap counts.
std::optional<ClockMap> clock_map(const SessionJoint& joint, const GapsAnswer& found);

/// Rows clock_hours,angle_deg,gap_mm for the cells that have a gap.
Table clock_table(const ClockMap& map);

}  // namespace impinge
