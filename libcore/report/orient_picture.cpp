// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/orient_picture.hpp"

#include <array>

#include "files/formatted.hpp"
#include "report/map_picture.hpp"

namespace impinge {
namespace {

struct StateShown {
  std::string fill;
  std::string_view text;
  double from_left;  // place of its key
  double MapAreas::*area;
};

// In the order of CellState.
std::array<StateShown, 4> states_shown() {
  return {{{free_shade(0.75), "free", 0.0, &MapAreas::free},
           {std::string(kMapBlocked), "blocked", 30.0, &MapAreas::blocked},
           {"#f1e3a0", "the ball's mesh ends", 112.0, &MapAreas::unknown},
           {std::string(kMapUndecided), "undecided", 66.0, &MapAreas::open}}};
}

// All squares of a state as one path: there may be tens of thousands.
std::string squares_of(const MapPicture& picture, const OrientAnswer& found, CellState state,
                       const std::string& fill) {
  std::string path;
  for (const OrientationCell& cell : found.cells) {
    if (cell.state != state) continue;
    const auto& [inclination, anteversion] = cell.middle;
    const double x = picture.x(inclination - cell.half_deg);
    const double side = picture.x(inclination + cell.half_deg) - x;
    path += formatted("M%g %gh%gv%gh%gz", x, picture.y(anteversion + cell.half_deg), side, side, -side);
  }
  return path.empty() ? path
                      : "<path fill=\"" + fill + "\" shape-rendering=\"crispEdges\" d=\"" + path + "\"/>\n";
}

std::string nearest_words(const OrientAnswer& found) {
  if (!found.nearest_free) return "no square of the map is free";
  const NearestOrientation& to = *found.nearest_free;
  const auto& [angles, change, turn] = to;
  return formatted("the dot is the nearest free one: %+.1f, %+.1f; a turn by %.1f", change.inclination_deg,
                   change.anteversion_deg, turn);
}

}  // namespace

std::string orient_picture(const OrientAnswer& found) {
  const auto& [now, map] = std::tie(found.as_scanned, found.map);
  MapPicture picture({.left = map.least_inclination_deg,
                      .right = map.least_inclination_deg + map.width_deg,
                      .bottom = map.least_anteversion_deg,
                      .top = map.least_anteversion_deg + map.width_deg,
                      .scale = 195.0 / map.width_deg,  // as wide as the map of the volume
                      .step_across = 15,
                      .step_up = 15,
                      .beside = "anteversion, degrees"});
  const std::array states = states_shown();
  for (std::size_t k = 0; k < states.size(); ++k)
    picture.add(squares_of(picture, found, static_cast<CellState>(k), states[k].fill));
  picture.name_angles();
  if (found.nearest_free)
    picture.mark(found.nearest_free->angles.inclination_deg, found.nearest_free->angles.anteversion_deg,
                 false);
  picture.mark(now.inclination_deg, now.anteversion_deg, true);
  picture.words(0, "inclination, degrees; the ring is the socket as scanned");
  picture.words(1, nearest_words(found));
  for (const StateShown& state : states)
    if (found.area_deg2.*state.area > 0.0) picture.key(2, state.from_left, state.fill, state.text);
  return picture.finished();
}

}  // namespace impinge
