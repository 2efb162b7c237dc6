// SPDX-License-Identifier: GPL-3.0-or-later
// The orientations of the socket in which a session's joint is free in required motions
// (change/orientation.hpp).
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "change/orientation.hpp"
#include "files/fields.hpp"
#include "joint/required_motions.hpp"
#include "joint/session.hpp"

namespace impinge {

struct OrientRequest {
  std::vector<Motion> require;  // degrees
  double tilt_deg = 0.0;
  double resolution_deg = 0.1;

  /// std::invalid_argument for what cannot be required.
  void check() const { check_required(require); }

  static constexpr std::tuple fields{
      Field{"require", "deg", kRequireText, &OrientRequest::require},
      Field{"tilt_deg",
            "deg",
            "of the pelvis backwards from its pose in the scan, which turns the socket forward",
            &OrientRequest::tilt_deg,
            {-90.0, 90.0}},
      Field{"resolution_deg",
            "deg",
            "of the map: undecided squares are not split below this",
            &OrientRequest::resolution_deg,
            {0.01, 90.0}}};
};

/// The socket as it is.
struct CupAsScanned {
  double inclination_deg = 0.0;
  double anteversion_deg = 0.0;
  CellState state = CellState::open;

  static constexpr std::tuple fields{
      Field{"inclination_deg", "deg", "radiographic (Murray 1993)", &CupAsScanned::inclination_deg},
      Field{"anteversion_deg", "deg", "radiographic (Murray 1993)", &CupAsScanned::anteversion_deg},
      Field{"state", "", "of the square of the map that holds it", &CupAsScanned::state}};
};

/// A square of angles.
struct MapExtent {
  double least_inclination_deg = 0.0;
  double least_anteversion_deg = 0.0;
  double width_deg = 0.0;
  std::size_t squares = 0;

  static constexpr std::tuple fields{
      Field{"least_inclination_deg", "deg", "where it begins", &MapExtent::least_inclination_deg},
      Field{"least_anteversion_deg", "deg", "where it begins", &MapExtent::least_anteversion_deg},
      Field{"width_deg", "deg", "of both angles", &MapExtent::width_deg},
      Field{"squares", "1", "that make it up", &MapExtent::squares}};
};

/// Square degrees (change/orientation.hpp).
struct MapAreas {
  double free = 0.0;
  double blocked = 0.0;
  double unknown = 0.0;
  double open = 0.0;

  static constexpr std::tuple fields{
      Field{"free", "deg^2", "every required motion is", &MapAreas::free},
      Field{"blocked", "deg^2", "one of them is", &MapAreas::blocked},
      Field{"unknown", "deg^2", "the ball's mesh ends under the socket on the way", &MapAreas::unknown},
      Field{"open", "deg^2", "undecided at the resolution", &MapAreas::open}};
};

struct OrientAnswer {
  CupAsScanned as_scanned;
  MapExtent map;
  MapAreas area_deg2;
  std::vector<std::string> legs;
  std::vector<OrientationCell> cells;  // the squares of the map; a leg of theirs is a place in `legs`

  static constexpr std::tuple fields{
      Field{"as_scanned", "",
            "the socket as it is, its angles in the pelvis; it turns about the centre of rotation",
            &OrientAnswer::as_scanned},
      Field{"map", "", "which angles were looked at", &OrientAnswer::map},
      Field{"area_deg2", "deg^2", "of the map in each state", &OrientAnswer::area_deg2},
      Field{"legs", "", "parts of the required paths, in words", &OrientAnswer::legs}};
};

/// std::runtime_error, one line, if the socket has no rim to measure its orientation by;
/// std::invalid_argument without a side, and as check().
OrientAnswer answer(Session& session, const OrientRequest& request);

}  // namespace impinge
