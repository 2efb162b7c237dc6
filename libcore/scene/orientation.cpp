// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/orientation.hpp"

#include "files/csv.hpp"
#include "files/file_set.hpp"
#include "files/formatted.hpp"
#include "joint/document.hpp"
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

std::string orientation_csv(const OrientAnswer& found) {
  Table table;
  table.columns = {
      {"inclination_deg", "deg", "radiographic, of the middle of a square of the map"},
      {"anteversion_deg", "deg", "radiographic, of the middle"},
      {"half_width_deg", "deg", "from the middle to the sides"},
      {"state", "", "free, blocked, open or unknown"},
      {"motion", "", "the required motion, or one of them, that is so; none where all are free"}};
  for (const OrientationCell& cell : found.cells)
    table.add_row({cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg, name(cell.state),
                   cell.leg ? found.legs[*cell.leg] : std::string()});
  return to_csv(table);
}

}  // namespace

OrientRequest orientation_request(const SceneOptions& options) {
  return {.require = options.change->required, .tilt_deg = options.change->tilt_deg};
}

json orientation_summary(const SceneOptions& options, const SessionJoint& joint, const OrientAnswer& found,
                         double milliseconds) {
  json report = asked_json(options, joint.joint);
  report.update({{"notice", kNoGuide},
                 {"angles", kWhichAngles},
                 {"path", kWhichPath},
                 {"tilt_deg", options.change->tilt_deg},
                 {"times_ms", {{"answer", milliseconds}}}});
  report.update(json::parse(json_of(found).dump()));
  report["map"]["resolution_deg"] = OrientRequest{}.resolution_deg;
  return report;
}

void write_orientation(const SceneOptions& options, const OrientAnswer& found, const json& summary) {
  FileSet files;
  files.add(options.out / "orientation.csv", orientation_csv(found));
  files.add(options.out / "orientation.json", json_text(summary));
  files.commit();
}

std::string describe_orientation(const SceneOptions& options, const OrientAnswer& found) {
  const auto& [now, map, area] = std::tie(found.as_scanned, found.map, found.area_deg2);
  return "required            " + options.change->text +
         formatted(", tilt %g degrees\n", options.change->tilt_deg) +
         formatted("socket as scanned   inclination %.1f, anteversion %.1f degrees (radiographic): %s\n",
                   now.inclination_deg, now.anteversion_deg, std::string(name(now.state)).c_str()) +
         formatted("map                 of inclination %g to %g and anteversion %g to %g degrees\n",
                   map.least_inclination_deg, map.least_inclination_deg + map.width_deg,
                   map.least_anteversion_deg, map.least_anteversion_deg + map.width_deg) +
         formatted("free                %.1f to %.1f of %.0f square degrees, %.1f unknown\n", area.free,
                   area.free + area.open, map.width_deg * map.width_deg, area.unknown) +
         std::string(kNoGuide) + "\n";
}

}  // namespace impinge
