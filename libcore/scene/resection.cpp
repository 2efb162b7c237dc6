// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/resection.hpp"

#include <algorithm>
#include <cmath>

#include "files/csv.hpp"
#include "files/file_set.hpp"
#include "files/formatted.hpp"
#include "joint/document.hpp"
#include "mesh/ply_writer.hpp"
#include "scene/asked.hpp"
#include "scene/json_values.hpp"
#include "scene/question.hpp"
#include "scene/scene_files.hpp"

namespace impinge {
namespace {

using nlohmann::json;

constexpr const char* kWhichCut =
    "least radial cut about the centre of rotation: it leaves no undercut, and behind the rim narrows the "
    "bone "
    "all the way out, where a cut that follows the rim could take less";
constexpr const char* kWhichRimCut =
    "least radial cut of the socket about the centre of rotation: all bone nearer to the centre than the "
    "ball "
    "reaches, with the clearance. Depth is along a ray from the surface to where the ball is clear of it, or "
    "a closed mesh ends. Where all of a wall goes, resected_socket.ply is open";
constexpr const char* kWhichLeast =
    "least cut of all: what the bone of the socket sweeps through within the clearance; bone beyond stays, "
    "over an undercut. swept.csv has the cells of the ball's surface and radii that hold all of it";

// A row for each stretch of rays, so that a cell may have several.
std::string swept_csv(const std::vector<LeastCut::Cell>& cells) {
  Table table;
  for (const char* corner : {"a", "b", "c"}) {
    for (const char* axis : {"_x", "_y", "_z"})
      table.columns.push_back({std::string(corner) + axis, "mm", "corner of a part of the ball's surface"});
  }
  table.columns.push_back(
      {"from_mm", "mm", "from the centre, along every ray through it: nothing nearer goes"});
  table.columns.push_back({"to_mm", "mm", "nothing from there on to the next stretch goes"});
  for (const LeastCut::Cell& cell : cells) {
    for (const RadiusRange& goes : cell.goes.spans()) {
      std::vector<Cell> row;
      for (const Vec3& x : cell.corners) row.insert(row.end(), {x.x(), x.y(), x.z()});
      row.insert(row.end(), {goes.low, goes.high});
      table.add_row(std::move(row));
    }
  }
  return to_csv(table);
}

std::string ends_text(const TwoEnds& ends, int places, const char* unit) {
  return rounded_down(ends[0], places) + " to " + rounded_up(ends[1], places) + " " + unit;
}

std::string extent_text(const CutExtent& size, Surface cut) {
  const std::string volume = size.volume_mm3 ? ends_text(*size.volume_mm3, 1, "mm^3") + " over " : "";
  return volume + ends_text(size.area_mm2, 1, "mm^2") + " of the " + std::string(name(cut)) + "'s surface, " +
         ends_text(size.depth_mm, 2, "mm");
}

std::string cut_text(const ResectAnswer& found) {
  if (!found.deepest) return "to remove           nothing: all of it is reached with that clearance\n";
  const Vec3& at = *found.deepest;
  std::string text = "least radial cut    " + extent_text(found, found.surface) + " deep at " +
                     formatted("(%.1f, %.1f, %.1f)\n", at.x(), at.y(), at.z());
  if (found.volume_why) return text + "volume              " + std::string(*found.volume_why) + "\n";
  if (std::isnan(found.mesh_volume_mm3)) return text;
  const std::string file = resected_file(found.surface);
  return text + file + std::string(20 - std::min<std::size_t>(file.size(), 19), ' ') +
         formatted("takes %.1f mm^3\n", found.mesh_volume_mm3);
}

std::string leg_text(const ResectLeg& leg) {
  const std::string was = leg.before.state == LimitState::free
                              ? "reached before the cut too"
                              : "ends at " + rounded_down(leg.before.low_deg, 2) + " degrees before the cut";
  const std::string now = leg.after.state == LimitState::limited ? "at " : "not before ";
  return leg.words + ": " + was + ", " + now + rounded_down(leg.after.low_deg, 2) + " after it\n";
}

}  // namespace

ResectRequest resection_request(const SceneOptions& options) {
  const ChangeOptions& change = *options.change;
  return {change.required,    change.clearance_mm,  change.cut,
          change.most_rim_mm, change.least_neck_mm, change.least};
}

json resection_summary(const SceneOptions& options, const SessionJoint& joint, const ResectAnswer& found,
                       double milliseconds) {
  json report = asked_json(options, joint.joint);
  report["units"]["volume"] = "mm^3";
  report.update({{"notice", kNoGuide},
                 {"cut", found.surface == Surface::ball ? kWhichCut : kWhichRimCut},
                 {"path", kWhichPath},
                 {"clearance_mm", options.change->clearance_mm},
                 {"times_ms", {{"answer", milliseconds}}}});
  report.update(json::parse(json_of(found).dump()));
  if (found.deepest) report["deepest"] = point_json(*found.deepest);
  if (found.least) report["least"]["cut"] = kWhichLeast;
  return report;
}

void write_resection(const SceneOptions& options, const ResectAnswer& found, const json& summary) {
  FileSet files;
  files.add(options.out / resected_file(found.surface), ply_bytes(found.mesh, "depth", found.depth));
  if (found.least) files.add(options.out / "swept.csv", swept_csv(found.swept));
  files.add(options.out / "resection.json", json_text(summary));
  files.commit();
}

std::string describe_resection(const SceneOptions& options, const ResectAnswer& found) {
  std::string text = "required            " + options.change->text +
                     formatted(", clearance %g mm\n", options.change->clearance_mm);
  text += cut_text(found);
  if (found.least)
    text += "least cut of all    " + extent_text(*found.least, Surface::ball) + " along a ray (swept.csv)\n";
  for (const ResectLeg& leg : found.legs) text += "                    " + leg_text(leg);
  if (found.neck)
    text += "neck                " + rounded_down(found.neck->after, 1) +
            " mm about its axis stays uncut, of " + rounded_down(found.neck->before, 1) + "\n";
  return text + std::string(kNoGuide) + "\n";
}

}  // namespace impinge
