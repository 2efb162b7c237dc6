// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// In which orientations of the socket are required motions free? A map over radiographic inclination and
/// anteversion (hip/cup_angles.hpp), as cells that are free, blocked or still open. Theorem 16 (orientation).
///
/// A socket that is turned by P about the centre of the ball meets the ball in the pose R as the socket at
/// rest meets it in P^-1 R. P = T M(a) M(a0)^-1, with T the tilt of the pelvis, a the angles of the map and
/// a0 those of the socket at rest. M is a turn by the inclination about one axis after one by the anteversion
/// about an axis square to it: of all angles within h of those in the middle of a cell no M is farther from
/// that of the middle than theta, cos(theta / 2) = cos^2(h / 2). So of all orientations of a cell and all
/// poses of a part of a leg (change/required_motion.hpp) no rotation is farther than theta + rho from one of
/// them, and rotations/cell_test.hpp decides them together. A cell is
///   free     every part of every leg is
///   blocked  some part is blocked, in all of its orientations
///   unknown  some part is unknown, and no other one is open or blocked
///   open     none of these is shown at the finest resolution
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "change/required_motion.hpp"
#include "hip/cup_angles.hpp"
#include "rotations/cell_test.hpp"

namespace impinge {

/// The map is a square of angles that is halved in both.
struct OrientationQuestion {
  std::vector<RequiredLeg> legs;  // joint frame, of a pelvis that is upright
  Side side = Side::right;        // of the body
  CupAngles at_rest;              // degrees, of the socket as it is given
  double tilt_deg = 0.0;          // of the pelvis backwards; angles of the map are those in the pelvis
  CupAngles least{0.0, -30.0};    // degrees, corner of the map
  double width_deg = 90.0;        // of the map, in both angles
  double resolution_deg = 0.1;    // cells that are no wider are not halved
};

/// A square of the map.
struct OrientationCell {
  CupAngles middle;       // degrees
  double half_deg = 0.0;  // from the middle to the sides
  CellState state = CellState::open;
  std::optional<std::size_t> leg;  // of a cell that is not free: index of a leg with that state
};

/// All cells, of which the map is made up. The same for every run.
std::vector<OrientationCell> orientation_map(const CellTest& joint, const OrientationQuestion& question);

/// One of a map, and the turn that leads there.
struct NearestOrientation {
  CupAngles angles;       // degrees, of the orientation
  CupAngles change;       // from where the socket is
  double turn_deg = 0.0;  // angle t of the rotation M(a) M(a0)^-1: with d and e the changes,
                          // cos(t / 2) = cos(d / 2) cos(e / 2)
};
/// The one in cells of these states to which the least turn leads, the first such; none without such a cell.
/// t grows with either change, so that of a cell it is the place with the smallest of both.
std::optional<NearestOrientation> nearest_orientation(std::span<const OrientationCell> cells,
                                                      const CupAngles& from,
                                                      std::initializer_list<CellState> states);

}  // namespace impinge
