// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/report.hpp"

#include <string>

#include "command/question_command.hpp"
#include "command/report_clock.hpp"
#include "command/report_page.hpp"
#include "command/report_plots.hpp"
#include "command/report_scene.hpp"
#include "command/volume_picture.hpp"
#include "files/formatted.hpp"
#include "files/rows.hpp"
#include "joint/joint_document.hpp"
#include "joint/joint_files.hpp"

namespace impinge {
namespace {

// As the question alone writes it: the first column is of many joints.
template <class Row, class Rows>
AnswerFile csv_of(const char* name, const Rows& rows) {
  Table table;
  table.columns = columns_of<Row>();
  table.columns.insert(table.columns.begin(), {"joint", "", "its folder, or empty"});
  for (const auto& row : rows) {
    std::vector<Cell> cells = cells_of<Row>(row);
    cells.insert(cells.begin(), Cell(""));
    table.add_row(std::move(cells));
  }
  return {name, to_csv(table)};
}

// A file is called by its name alone: the same bytes wherever it lies.
Json without_folders(Json joint, const std::vector<std::filesystem::path>& files) {
  for (Json& line : joint["warnings"]) {
    std::string text = line;
    for (const std::filesystem::path& file : files) {
      const std::string whole = file.string();
      for (std::size_t at = text.find(whole); !whole.empty() && at != text.npos;
           at = text.find(whole, at + 1))
        text.replace(at, whole.size(), file.filename().string());
    }
    line = text;
  }
  return joint;
}

VolumeSettings volume_settings(const ReportRequest& request, const Work& work) {
  VolumeSettings how{.most_cells = kMostVolumeCells, .threads = work.threads};
  how.reached = [&request, &work, watch = Stopwatch(), silent_ms = 0.0](std::span<const CellVerdict>,
                                                                        double open) mutable {
    constexpr double kSilence = 2000.0;  // ms
    if ((silent_ms += watch.lap_ms()) < kSilence) return;
    silent_ms = 0.0;
    work.say(formatted("%.3f of all rotations open, %.3f wanted", open, request.width));
  };
  return how;
}

ReportParts parts_of(const SessionJoint& joint, const ReportRequest& request, const ReportAnswer& found,
                     const Json& said, const Work& work) {
  ReportParts parts{.ball = work.inputs.at(0).filename().string(),
                    .socket = work.inputs.at(1).filename().string()};
  parts.joint = without_folders(json_of(describe(joint, {parts.ball, parts.socket})), work.inputs);
  parts.doubts = joint.joint.doubts;
  parts.request = json_of(request);
  parts.answer = said;
  parts.scene = report_scene(joint, found.gaps);
  if (const std::optional<ClockMap> map = clock_map(joint, found.gaps))
    parts.clock = clock_plot(*map, said["gaps"]);
  if (found.limits) parts.limits = limits_plot(said["limits"]);
  if (found.volume) parts.volume = volume_picture(found.volume->volume, *joint.side);
  if (found.measures) parts.measures = measures_plot(said["measures"]);
  return parts;
}

void add_files(Told& told, const SessionJoint& joint, const ReportAnswer& found, const ReportParts& parts) {
  told.files = {{"report.html", report_page(parts)}, {"gaps.csv", gaps_csv(joint, found.gaps)}};
  if (const std::optional<ClockMap> map = clock_map(joint, found.gaps))
    told.files.push_back({"clock.csv", to_csv(clock_table(*map))});
  if (found.limits) told.files.push_back(csv_of<LimitRow>("limits.csv", found.limits->limits));
  if (found.measures) told.files.push_back(csv_of<MeasureRow>("measures.csv", found.measures->measures));
  for (const auto& [name, svg] :
       {std::pair("clock.svg", &parts.clock), std::pair("limits.svg", &parts.limits),
        std::pair("volume.svg", &parts.volume), std::pair("measures.svg", &parts.measures)})
    if (!svg->empty()) told.files.push_back({name, *svg});
}

Told tell_report(Session& session, const ReportRequest& request, const Work& work) {
  if (!work.out) throw std::invalid_argument("--out: a report needs a folder for its files; give --out DIR");
  const ReportAnswer found = answer(session, request, volume_settings(request, work));
  const SessionJoint& joint = *session.joint;
  Told told{.words = {}, .document = json_of(found)};
  told.row_of_one = {{"contact", "/gaps/contact/state"}, {"smallest_gap_mm", "/gaps/smallest_gap/gap_mm"}};
  add_files(told, joint, found, parts_of(joint, request, found, told.document, work));
  if (!has_viewer()) work.warn("report.html does not draw the bones: " + viewer_missing());
  told.words = "report              open " + (*work.out / "report.html").string() + " in a browser\n";
  return told;
}

}  // namespace

QuestionCommand report_question() {
  QuestionCommand made = question_of<ReportRequest, ReportAnswer>(
      "report",
      "All of a joint on one page: bones coloured by gap, range of motion, rotations, measures, warnings.",
      "femur.ply pelvis.ply --side right --out report", &tell_report);
  made.takes_map = true;
  return made;
}

}  // namespace impinge
