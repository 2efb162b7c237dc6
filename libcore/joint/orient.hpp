// SPDX-License-Identifier: GPL-3.0-or-later
// The orientations of the socket in which a session's joint is free in required motions
// (change/orientation.hpp).
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "change/orientation.hpp"
#include "files/fields.hpp"
#include "joint/required_motions.hpp"
#include "joint/session.hpp"
#include "joint/volume.hpp"

namespace impinge {

struct OrientRequest {
  std::vector<Motion> require;  // degrees
  double tilt_deg = 0.0;
  double resolution_deg = 0.1;
  std::optional<double> inclination_deg{};
  std::optional<double> anteversion_deg{};

  /// Throws std::invalid_argument for motions that cannot be required, and for one angle without the other.
  void check() const {
    check_required(require);
    if (inclination_deg.has_value() != anteversion_deg.has_value())
      throw std::invalid_argument(
          std::string(inclination_deg ? "inclination" : "anteversion") +
          "_deg: inclination and anteversion go together; give the other, too, or leave both out");
  }

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
            {0.01, 90.0}},
      Field{"inclination_deg",
            "deg",
            "of the socket as scanned, radiographic, where its rim does not show it [measured]",
            &OrientRequest::inclination_deg,
            {-90.0, 90.0}},
      Field{"anteversion_deg",
            "deg",
            "radiographic anteversion of the socket as scanned [measured]",
            &OrientRequest::anteversion_deg,
            {-90.0, 90.0}}};
};

/// The socket as it is.
struct CupAsScanned : CupAngles {
  std::string angles = "given";
  CellState state = CellState::open;

  static constexpr std::tuple fields{
      Field{"inclination_deg", "deg", "radiographic (Murray 1993)", &CupAsScanned::inclination_deg},
      Field{"anteversion_deg", "deg", "radiographic (Murray 1993)", &CupAsScanned::anteversion_deg},
      Field{"angles", "", "measured, measured to the end of the mesh, or given", &CupAsScanned::angles},
      Field{"state", "", "of the square of the map that holds it", &CupAsScanned::state}};
};

/// The nearest orientation that is proven free, and the turn to it.
struct NearestFree : NearestOrientation {
  std::optional<Vec3> axis;  // none where nothing turns
  double at_least_deg = 0.0;

  static constexpr std::tuple fields{
      Field{"inclination_deg", "deg", "radiographic", via(&NearestFree::angles, &CupAngles::inclination_deg)},
      Field{"anteversion_deg", "deg", "radiographic", via(&NearestFree::angles, &CupAngles::anteversion_deg)},
      Field{"inclination_change_deg", "deg", "from the socket as scanned",
            via(&NearestFree::change, &CupAngles::inclination_deg)},
      Field{"anteversion_change_deg", "deg", "the same",
            via(&NearestFree::change, &CupAngles::anteversion_deg)},
      Field{"turn_deg", "deg",
            "angle of the one rotation about the centre that does both; the least there is",
            &NearestFree::turn_deg},
      Field{"turn_axis", "",
            "unit vector in the frame of the meshes, by the right-hand rule; none where nothing turns",
            &NearestFree::axis},
      Field{"at_least_deg", "deg",
            "no orientation of the map is free after a smaller turn: undecided ones may be",
            &NearestFree::at_least_deg}};
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
      Field{"free", "deg^2", "where every required motion is free", &MapAreas::free},
      Field{"blocked", "deg^2", "where one of them is blocked", &MapAreas::blocked},
      Field{"unknown", "deg^2", "where the ball's mesh ends under the socket on the way", &MapAreas::unknown},
      Field{"open", "deg^2", "undecided at the resolution", &MapAreas::open}};
};

struct OrientAnswer {
  CupAsScanned as_scanned;
  std::optional<NearestFree> nearest_free;  // none if no square of the map is proven free
  MapExtent map;
  MapAreas area_deg2;
  bool by_radii = false;
  std::vector<std::string> legs;
  std::vector<OrientationCell> cells;  // squares of the map; their legs are indices into `legs`

  static constexpr std::tuple fields{
      Field{"as_scanned", "",
            "the socket as it is, its angles in the pelvis; it turns about the centre of rotation",
            &OrientAnswer::as_scanned},
      Field{"nearest_free", "",
            "by the angle of the turn that leads there; none where no square of the map is free",
            &OrientAnswer::nearest_free},
      Field{"map", "", "which angles were looked at", &OrientAnswer::map},
      Field{"area_deg2", "deg^2", "of the map in each state", &OrientAnswer::area_deg2},
      Field{"by_radii", "", kByRadii, &OrientAnswer::by_radii},
      Field{"legs", "", "parts of the required paths, in words", &OrientAnswer::legs}};
};

/// Throws std::runtime_error, one line, if no angles are given and the socket's rim cannot be trusted
/// (hip/measure_list.hpp); std::invalid_argument without a side, and as check() does.
OrientAnswer answer(Session& session, const OrientRequest& request);

}  // namespace impinge
