// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/report.hpp"

#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "report/files.hpp"
#include "report/page.hpp"

namespace impinge {
namespace {

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

Told tell_report(Session& session, const ReportRequest& request, const Work& work) {
  if (!work.out) throw std::invalid_argument("--out: a report needs a folder for its files; give --out DIR");
  const ReportAnswer found = answer(session, request, volume_settings(request, work));
  Told told{.words = {},
            .document = json_of(found),
            .files = report_files(*session.joint, request, found, work.inputs)};
  told.row_of_one = {{"contact", "/gaps/contact/state"}, {"smallest_gap_mm", "/gaps/smallest_gap/gap_mm"}};
  if (kReportViewer.empty()) work.warn("report.html does not draw the bones: " + viewer_missing());
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
