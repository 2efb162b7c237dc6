// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/resect.hpp"

#include <algorithm>
#include <cmath>

#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "mesh/io.hpp"

namespace impinge {
namespace {

// One row for each stretch of a cell's rays; a cell may have several.
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

std::string ends_text(const Ends& ends, int places, const char* unit) {
  return rounded_down(ends.low, places) + " to " + rounded_up(ends.high, places) + " " + unit;
}

std::string extent_text(const CutSize& size, Surface cut) {
  const std::string volume =
      known_ends(size.volume_mm3) ? ends_text(size.volume_mm3, 1, "mm^3") + " over " : "";
  return volume + ends_text(size.area_mm2, 1, "mm^2") + " of the " + std::string(name(cut)) + "'s surface, " +
         ends_text(size.depth_mm, 2, "mm");
}

std::string cut_text(const ResectAnswer& found, const std::string& file) {
  if (!found.deepest) return "to remove           nothing: all of it is reached with that clearance\n";
  const Vec3& at = *found.deepest;
  std::string text = "least radial cut    " + extent_text(found, found.surface) + " deep at " +
                     formatted("(%.1f, %.1f, %.1f)\n", at.x(), at.y(), at.z());
  if (found.volume_why) return text + "volume              " + std::string(*found.volume_why) + "\n";
  if (std::isnan(found.mesh_volume_mm3)) return text;
  return text + file + std::string(20 - std::min<std::size_t>(file.size(), 19), ' ') +
         formatted("takes %.1f mm^3\n", found.mesh_volume_mm3);
}

std::string leg_text(const ResectLeg& leg) {
  const std::string was = leg.before.state == LimitState::free
                              ? "reached before the cut too"
                              : "ends at " + rounded_down(leg.before.low_deg, 2) + " degrees before the cut";
  const std::string now = leg.after.state == LimitState::limited ? "at " : "not before ";
  return describe(leg) + ": " + was + ", " + now + rounded_down(leg.after.low_deg, 2) + " after it\n";
}

std::string screen_text(const ResectAnswer& found, double clearance_mm, const std::string& file) {
  std::string text = formatted("clearance           %g mm\n", clearance_mm) + cut_text(found, file);
  if (found.least)
    text += "least cut of all    " + extent_text(*found.least, Surface::ball) + " along a ray (swept.csv)\n";
  for (const ResectLeg& leg : found.legs)
    text += (&leg == &found.legs.front() ? "required            " : "                    ") + leg_text(leg);
  if (found.neck)
    text += "neck                " + rounded_down(found.neck->after, 1) +
            " mm about its axis stays uncut, of " + rounded_down(found.neck->before, 1) + "\n";
  return text + std::string(kNoGuide) + "\n";
}

Told told(Session& session, const ResectRequest& request, const Work& work) {
  const ResectAnswer found = answer(session, request);
  const std::string file = work.mesh_file("resected_" + std::string(name(found.surface)));
  Told told{.words = screen_text(found, request.clearance_mm, file), .document = json_of(found)};
  const MeshNotes notes{.axes = session.joint->joint.axes, .values = {{"depth", found.depth}}};
  told.files.push_back({file, mesh_bytes(file, found.mesh, notes)});
  if (found.least) told.files.push_back({"swept.csv", swept_csv(found.swept)});
  told.files.push_back({"resection.json", text_of(told.document)});
  told.row_of_one = {{"volume_low_mm3", "/volume_mm3/0"}, {"volume_high_mm3", "/volume_mm3/1"},
                     {"area_low_mm2", "/area_mm2/0"},     {"area_high_mm2", "/area_mm2/1"},
                     {"depth_low_mm", "/depth_mm/0"},     {"depth_high_mm", "/depth_mm/1"}};
  if (found.least) {
    told.row_of_one.push_back({"least_volume_low_mm3", "/least/volume_mm3/0"});
    told.row_of_one.push_back({"least_volume_high_mm3", "/least/volume_mm3/1"});
  }
  return told;
}

}  // namespace

QuestionCommand resect_question() {
  QuestionCommand made = question_of<ResectRequest, ResectAnswer>(
      "resect",
      "The bone that would have to go so that motions are reached: of the ball, or of the socket's rim.",
      "femur.ply pelvis.ply --side right --require flexion=90,internal_rotation=30", &told);
  made.writes_meshes = true;
  return made;
}

}  // namespace impinge
