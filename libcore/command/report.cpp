// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/report.hpp"

#include <string>

#include "command/joint_command.hpp"
#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "files/rows.hpp"
#include "joint/joint_files.hpp"
#include "report/clock.hpp"
#include "report/page.hpp"

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
  const auto name = [&work](std::size_t k) { return work.inputs.at(k).filename().string(); };
  ReportParts parts = report_parts(joint, {.ball = name(0), .socket = name(1)}, request, found);
  parts.joint = without_folders(parts.joint, work.inputs);
  parts.program = std::string("impinge ") + kVersion + ", commit " + commit();
  parts.viewer = kReportViewer;
  Told told{.words = {}, .document = parts.answer};
  told.row_of_one = {{"contact", "/gaps/contact/state"}, {"smallest_gap_mm", "/gaps/smallest_gap/gap_mm"}};
  add_files(told, joint, found, parts);
  if (parts.viewer.empty()) work.warn("report.html does not draw the bones: " + viewer_missing());
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
