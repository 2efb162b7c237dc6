// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/orientation.hpp"

#include "files/csv.hpp"
#include "files/file_set.hpp"
#include "files/formatted.hpp"
#include "scene/asked.hpp"
#include "scene/question.hpp"
#include "scene/resection.hpp"

namespace impinge {
namespace {

using nlohmann::json;

constexpr const char* kWhichAngles =
    "radiographic inclination and anteversion (Murray 1993) of the socket in its pelvis; the socket turns "
    "about "
    "the centre of rotation, and a tilt of the pelvis backwards turns it forward";

std::string orientation_csv(const OrientationAnswer& found) {
  Table table;
  table.columns = {
      {"inclination_deg", "deg", "radiographic, of the middle of a square of the map"},
      {"anteversion_deg", "deg", "radiographic, of the middle"},
      {"half_width_deg", "deg", "from the middle to the sides"},
      {"state", "", "free, blocked, open or unknown"},
      {"motion", "", "the required motion, or one of them, that is so; none where all are free"}};
  for (const OrientationCell& cell : found.cells)
    table.add_row({cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg, name(cell.state),
                   cell.leg ? describe(found.question.legs[*cell.leg]) : std::string()});
  return to_csv(table);
}

}  // namespace

OrientationRequest orientation_request(const SceneOptions& options) {
  return {.required = options.change->required, .tilt_deg = options.change->tilt_deg};
}

json orientation_summary(const SceneOptions& options, const SessionJoint& joint,
                         const OrientationAnswer& found, double milliseconds) {
  const OrientationQuestion& question = found.question;
  json report = asked_json(options, joint.joint);
  report.update(
      {{"notice", kNoGuide},
       {"angles", kWhichAngles},
       {"path", kWhichPath},
       {"tilt_deg", question.tilt_deg},
       {"as_scanned",
        {{"inclination_deg", question.at_rest.inclination_deg},
         {"anteversion_deg", question.at_rest.anteversion_deg},
         {"state", name(found.as_scanned)}}},
       {"map",
        {{"least_inclination_deg", question.least.inclination_deg},
         {"least_anteversion_deg", question.least.anteversion_deg},
         {"width_deg", question.width_deg},
         {"resolution_deg", question.resolution_deg},
         {"squares", found.cells.size()}}},
       {"area_deg2",
        {{"free", found.free}, {"blocked", found.blocked}, {"unknown", found.unknown}, {"open", found.open}}},
       {"times_ms", {{"answer", milliseconds}}}});
  return report;
}

void write_orientation(const SceneOptions& options, const OrientationAnswer& found, const json& summary) {
  FileSet files;
  files.add(options.out / "orientation.csv", orientation_csv(found));
  files.add(options.out / "orientation.json", json_text(summary));
  files.commit();
}

std::string describe_orientation(const SceneOptions& options, const OrientationAnswer& found) {
  const OrientationQuestion& question = found.question;
  return "required            " + options.change->text + formatted(", tilt %g degrees\n", question.tilt_deg) +
         formatted("socket as scanned   inclination %.1f, anteversion %.1f degrees (radiographic): %s\n",
                   question.at_rest.inclination_deg, question.at_rest.anteversion_deg,
                   std::string(name(found.as_scanned)).c_str()) +
         formatted("map                 of inclination %g to %g and anteversion %g to %g degrees\n",
                   question.least.inclination_deg, question.least.inclination_deg + question.width_deg,
                   question.least.anteversion_deg, question.least.anteversion_deg + question.width_deg) +
         formatted("free                %.1f to %.1f of %.0f square degrees, %.1f unknown\n", found.free,
                   found.free + found.open, question.width_deg * question.width_deg, found.unknown) +
         kNoGuide + "\n";
}

}  // namespace impinge
