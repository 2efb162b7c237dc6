// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a joint in one pose.
#pragma once

#include <optional>
#include <string>

#include "hip/motion.hpp"
#include "joint/needed_work.hpp"

namespace impinge {

inline constexpr double kUsualPrecision = 0.5;  // degrees, of tables if no precision is given

/// Lengths in mm, angles in degrees.
struct PoseQuestion {
  std::string scheme = "rsid";          // name of the sampling scheme of the tables
  std::optional<double> precision_deg;  // of the tables
  std::optional<double> max_error_mm;   // of every gap, refused where it cannot be kept; not with tables
  Motion motion;                        // of the femur from the pose of the scan
  double cartilage_mm = 4.0;            // both layers together; the thesis' value
  bool scan_ball = true;                // the first scan: vertices of the ball against the socket
  bool scan_socket = true;              // the second scan
  PoseOutputs outputs;

  /// Are tables used? Only if asked for: for one pose the faces are faster than filling a table.
  bool by_tables() const { return precision_deg.has_value(); }
};

}  // namespace impinge
