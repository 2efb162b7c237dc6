// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/orient.hpp"

#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "report/orient_picture.hpp"

namespace impinge {
namespace {

std::string orientation_csv(const OrientAnswer& found) {
  Table table;
  table.columns = {
      {"inclination_deg", "deg", "radiographic, of the middle of a square of the map"},
      {"anteversion_deg", "deg", "radiographic, of the middle"},
      {"half_width_deg", "deg", "from the middle to the sides"},
      {"state", "", "free, blocked, open or unknown"},
      {"motion", "",
       "the required motion that decides the state, one of them if several do; none where all are free"}};
  for (const OrientationCell& cell : found.cells)
    table.add_row({cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg, name(cell.state),
                   cell.leg ? found.legs[*cell.leg] : std::string()});
  return to_csv(table);
}

// Where to turn the socket, and how.
std::string nearest_text(const OrientAnswer& found) {
  if (!found.nearest_free) return "nearest free        none: no square of the map is\n";
  const NearestFree& to = *found.nearest_free;
  if (!to.axis) return "nearest free        the socket as scanned\n";
  std::string text =
      formatted("nearest free        inclination %.1f, anteversion %.1f degrees: %+.1f and %+.1f\n",
                to.angles.inclination_deg, to.angles.anteversion_deg, to.change.inclination_deg,
                to.change.anteversion_deg) +
      formatted(
          "                    a turn of the socket by %.1f degrees about the axis %.3f, %.3f, %.3f of the "
          "frame of the meshes",
          to.turn_deg, to.axis->x(), to.axis->y(), to.axis->z());
  if (to.at_least_deg < to.turn_deg)
    text += formatted("; none is free after less than %s", rounded_down(to.at_least_deg, 1).c_str());
  return text + "\n";
}

std::string screen_text(const OrientAnswer& found, double tilt_deg) {
  const auto& [now, map, area] = std::tie(found.as_scanned, found.map, found.area_deg2);
  std::string text;
  for (const std::string& leg : found.legs)
    text += (text.empty() ? "required            " : "                    ") + leg + "\n";
  return text + formatted("tilt                %g degrees\n", tilt_deg) +
         formatted("socket as scanned   inclination %.1f, anteversion %.1f degrees (radiographic, %s): %s\n",
                   now.inclination_deg, now.anteversion_deg, now.angles.c_str(),
                   std::string(name(now.state)).c_str()) +
         nearest_text(found) +
         formatted("map                 of inclination %g to %g and anteversion %g to %g degrees\n",
                   map.least_inclination_deg, map.least_inclination_deg + map.width_deg,
                   map.least_anteversion_deg, map.least_anteversion_deg + map.width_deg) +
         formatted("free                %.1f to %.1f of %.0f square degrees, %.1f unknown\n", area.free,
                   area.free + area.open, map.width_deg * map.width_deg, area.unknown) +
         (found.by_radii && area.blocked > 0.0 ? std::string(kBlockedByRadii) + "\n" : "") +
         std::string(kNoGuide) + "\n";
}

Told told(Session& session, const OrientRequest& request, const Work& /*work*/) {
  const OrientAnswer found = answer(session, request);
  Told told{.words = screen_text(found, request.tilt_deg), .document = json_of(found)};
  told.files = {{"orientation.csv", orientation_csv(found)},
                {"orientation.json", text_of(told.document)},
                {"orientation.svg", orient_picture(found)}};
  told.row_of_one = {{"inclination_deg", "/as_scanned/inclination_deg"},
                     {"anteversion_deg", "/as_scanned/anteversion_deg"},
                     {"angles", "/as_scanned/angles"},
                     {"state", "/as_scanned/state"},
                     {"free_deg2", "/area_deg2/free"},
                     {"blocked_deg2", "/area_deg2/blocked"},
                     {"unknown_deg2", "/area_deg2/unknown"},
                     {"open_deg2", "/area_deg2/open"}};
  return told;
}

}  // namespace

QuestionCommand orient_question() {
  return question_of<OrientRequest, OrientAnswer>(
      "orient", "In which orientations of the socket motions are free, over inclination and anteversion.",
      "femur.ply pelvis.ply --side right --require flexion=90,internal_rotation=30", &told);
}

}  // namespace impinge
