// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// In which orientations of the socket are required motions free? A map over radiographic inclination and
/// anteversion (hip/cup_angles.hpp), as cells that are free, blocked or still open. Theorem 16 (orientation).
///
///   free     every part of every leg (change/required_motion.hpp) is free in all orientations of the cell
///   blocked  some part is blocked in all of its poses and in all orientations of the cell
///   unknown  some part is unknown (rotations/cell_test.hpp), and no other one is open or blocked
///   open     none of these could be shown at the finest resolution
///
/// To turn the socket by P about the centre of the ball is to turn the ball by P^-1: rotations/cell_test.hpp
/// decides all orientations of a cell and all poses of a part together. P = T M(a) M(a0)^-1, with T the tilt
/// of the pelvis, a the angles of the map, a0 those of the socket at rest and M cup_rotation().
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "change/required_motion.hpp"
#include "hip/cup_angles.hpp"
#include "rotations/cell_test.hpp"

namespace impinge {

/// The map is a square of angles. Its cells are squares, divided into four where they are open.
struct OrientationQuestion {
  std::vector<RequiredLeg> legs;  // required motions, joint frame of an upright pelvis
  Side side = Side::right;        // of the body
  CupAngles at_rest;              // degrees, angles of the socket as it is given
  double tilt_deg = 0.0;        // tilt of the pelvis backwards; angles of the map are relative to the pelvis
  CupAngles least{0.0, -30.0};  // degrees, the corner of the map with the least angles
  double width_deg = 90.0;      // width of the map in both angles
  double resolution_deg = 0.1;  // cells of this width or less are not divided
};

/// A square of the map.
struct OrientationCell {
  CupAngles middle;       // degrees
  double half_deg = 0.0;  // half of its width
  CellState state = CellState::open;
  std::optional<std::size_t> leg;  // if the cell is not free: index of a leg that has its state
};

/// The cells that make up the map. The same in every run.
std::vector<OrientationCell> orientation_map(const CellTest& joint, const OrientationQuestion& question);

/// An orientation of a map, and the turn that leads there.
struct NearestOrientation {
  CupAngles angles;       // degrees
  CupAngles change;       // degrees, from where the socket is
  double turn_deg = 0.0;  // angle t of the rotation, cos(t / 2) = cos(d / 2) cos(e / 2) for the changes d, e
};
/// The orientation in the cells of these states that the least turn leads to, the first of several; none
/// without such a cell.
std::optional<NearestOrientation> nearest_orientation(std::span<const OrientationCell> cells,
                                                      const CupAngles& from,
                                                      std::initializer_list<CellState> states);

}  // namespace impinge
