// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/resection.hpp"

#include <algorithm>
#include <cmath>

#include "files/csv.hpp"
#include "files/file_set.hpp"
#include "files/formatted.hpp"
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
constexpr const char* kNoVolume =
    "the socket is no closed mesh of one orientation, so that it is not known how thick its bone is";
constexpr const char* kWhichLeast =
    "least cut of all: what the bone of the socket sweeps through within the clearance; bone beyond stays, "
    "over an undercut. swept.csv has the cells of the ball's surface and radii that hold all of it";

json ends_json(const Ends& ends) { return interval_json(ends.low, ends.high); }

bool knows_volume(const CutSize& size) { return std::isfinite(size.volume_mm3.high); }

json size_json(const CutSize& size) {
  json found{{"volume_mm3", nullptr},
             {"area_mm2", ends_json(size.area_mm2)},
             {"depth_mm", ends_json(size.depth_mm)}};
  if (knows_volume(size))
    found["volume_mm3"] = ends_json(size.volume_mm3);
  else
    found["volume_why"] = kNoVolume;
  return found;
}

json least_json(const std::optional<LeastCut>& least) {
  if (!least) return nullptr;
  json found = size_json(*least);
  found["cut"] = kWhichLeast;
  found["cells"] = least->cells.size();
  return found;
}

// A row for each stretch of rays, so that a cell may have several.
std::string swept_csv(const SessionJoint& joint, const LeastCut& least) {
  Table table;
  for (const char* corner : {"a", "b", "c"}) {
    for (const char* axis : {"_x", "_y", "_z"})
      table.columns.push_back({std::string(corner) + axis, "mm", "corner of a part of the ball's surface"});
  }
  table.columns.push_back(
      {"from_mm", "mm", "from the centre, along every ray through it: nothing nearer goes"});
  table.columns.push_back({"to_mm", "mm", "nothing from there on to the next stretch goes"});
  for (const LeastCut::Cell& cell : least.cells) {
    for (const RadiusRange& goes : cell.goes.spans()) {
      std::vector<Cell> row;
      for (const Vec3& corner : cell.corners) {
        const Vec3 x = joint.axes.transpose() * corner + joint.joint.centre;
        row.insert(row.end(), {x.x(), x.y(), x.z()});
      }
      row.insert(row.end(), {goes.low, goes.high});
      table.add_row(std::move(row));
    }
  }
  return to_csv(table);
}

json bracket_json(const TurnLimit& limit) {
  return {{"state", name(limit.state)}, {"low_deg", limit.low_deg}, {"high_deg", limit.high_deg}};
}

json legs_json(const ResectionAnswer& found) {
  json legs = json::array();
  for (const ReachedLeg& reached : found.legs) {
    const Motion& start = reached.leg.start;
    legs.push_back({{"motion", reached.leg.growing},
                    {"start",
                     {{"flexion", start.flexion},
                      {"abduction", start.abduction},
                      {"internal_rotation", start.internal_rotation}}},
                    {"required_deg", reached.leg.largest_deg},
                    {"before", bracket_json(reached.before)},
                    {"after", bracket_json(reached.after)}});
  }
  return legs;
}

json neck_json(const std::optional<NeckBar>& neck) {
  if (!neck) return nullptr;
  return {{"least_mm", neck->least}, {"before_mm", neck->before}, {"after_mm", neck->after}};
}

std::string ends_text(const Ends& ends, int places, const char* unit) {
  return rounded_down(ends.low, places) + " to " + rounded_up(ends.high, places) + " " + unit;
}

std::string size_text(const CutSize& size, Surface cut) {
  const std::string volume = knows_volume(size) ? ends_text(size.volume_mm3, 1, "mm^3") + " over " : "";
  return volume + ends_text(size.area_mm2, 1, "mm^2") + " of the " + std::string(name(cut)) + "'s surface, " +
         ends_text(size.depth_mm, 2, "mm");
}

std::string cut_text(const ResectionAnswer& found) {
  const Resection& cut = found.cut;
  if (cut.empty()) return "to remove           nothing: all of it is reached with that clearance\n";
  const Vec3& at = found.deepest;
  std::string text = "least radial cut    " + size_text(cut, cut.of) + " deep at " +
                     formatted("(%.1f, %.1f, %.1f)\n", at.x(), at.y(), at.z());
  if (!knows_volume(cut)) return text + "volume              " + kNoVolume + "\n";
  if (std::isnan(cut.cut_mm3)) return text;
  const std::string file = resected_file(cut.of);
  return text + file + std::string(20 - std::min<std::size_t>(file.size(), 19), ' ') +
         formatted("takes %.1f mm^3\n", cut.cut_mm3);
}

std::string leg_text(const ReachedLeg& reached) {
  const TurnLimit& before = reached.before;
  const std::string was = before.state == LimitState::free
                              ? "reached before the cut too"
                              : "ends at " + rounded_down(before.low_deg, 2) + " degrees before the cut";
  const TurnLimit& after = reached.after;
  const std::string now = after.state == LimitState::limited ? "at " + rounded_down(after.low_deg, 2)
                                                             : "not before " + rounded_down(after.low_deg, 2);
  return describe(reached.leg) + ": " + was + ", " + now + " after it\n";
}

}  // namespace

ResectionRequest resection_request(const SceneOptions& options) {
  const ChangeOptions& change = *options.change;
  return {change.required, change.clearance_mm, change.least_neck_mm,
          change.least,    change.cut,          change.most_rim_mm.value_or(kMostRim)};
}

json resection_summary(const SceneOptions& options, const SessionJoint& joint, const ResectionAnswer& found,
                       double milliseconds) {
  json report = asked_json(options, joint.joint);
  report["units"]["volume"] = "mm^3";
  report.update({{"notice", kNoGuide},
                 {"surface", name(found.cut.of)},
                 {"cut", found.cut.of == Surface::ball ? kWhichCut : kWhichRimCut},
                 {"path", kWhichPath},
                 {"clearance_mm", options.change->clearance_mm},
                 {"deepest", found.cut.empty() ? json(nullptr) : point_json(found.deepest)},
                 {"mesh_volume_mm3", number_json(found.cut.cut_mm3)},
                 {"least", least_json(found.least)},
                 {"neck", neck_json(found.neck)},
                 {"legs", legs_json(found)},
                 {"times_ms", {{"answer", milliseconds}}}});
  report.update(size_json(found.cut));
  return report;
}

void write_resection(const SceneOptions& options, const SessionJoint& joint, const ResectionAnswer& found,
                     const json& summary) {
  TriangleMesh cut = found.cut.cut;
  for (Vec3& x : cut.vertices) x = joint.axes.transpose() * x + joint.joint.centre;
  FileSet files;
  files.add(options.out / resected_file(found.cut.of), ply_bytes(cut, "depth", found.cut.depth));
  if (found.least) files.add(options.out / "swept.csv", swept_csv(joint, *found.least));
  files.add(options.out / "resection.json", json_text(summary));
  files.commit();
}

std::string describe_resection(const SceneOptions& options, const ResectionAnswer& found) {
  std::string text = "required            " + options.change->text +
                     formatted(", clearance %g mm\n", options.change->clearance_mm);
  text += cut_text(found);
  if (found.least)
    text += "least cut of all    " + size_text(*found.least, Surface::ball) + " along a ray (swept.csv)\n";
  for (const ReachedLeg& leg : found.legs) text += "                    " + leg_text(leg);
  if (found.neck)
    text += "neck                " + rounded_down(found.neck->after, 1) +
            " mm about its axis stays uncut, of " + rounded_down(found.neck->before, 1) + "\n";
  return text + kNoGuide + "\n";
}

}  // namespace impinge
