// SPDX-License-Identifier: GPL-3.0-or-later
// The orientations of the socket in which a session's joint is free in required motions
// (change/orientation.hpp).
#pragma once

#include <vector>

#include "change/orientation.hpp"
#include "joint/session.hpp"

namespace impinge {

/// What is asked.
struct OrientationRequest {
  std::vector<Motion> required;  // degrees; each along its own path (change/required_motion.hpp)
  double tilt_deg = 0.0;         // of the pelvis backwards from its pose in the scan
  double resolution_deg = 0.1;   // of the map: undecided cells are not split below this
};

/// The map of orientations. Areas in square degrees.
struct OrientationAnswer {
  OrientationQuestion question;        // that was asked of the cells
  std::vector<OrientationCell> cells;  // that make up the map
  double free = 0.0;  // area of cells in this state; so the next three (change/orientation.hpp)
  double blocked = 0.0;
  double unknown = 0.0;
  double open = 0.0;
  CellState as_scanned = CellState::open;  // of the cell that holds the socket as it is
};

/// The socket turns about the centre of the ball. std::runtime_error, one line, if the socket has no rim to
/// measure its orientation by; std::invalid_argument without a side.
OrientationAnswer answer_orientation(Session& session, const OrientationRequest& request);

}  // namespace impinge
