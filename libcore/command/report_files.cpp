// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/report_files.hpp"

#include <string>

#include "command/report_clock.hpp"
#include "command/report_page.hpp"
#include "command/report_plots.hpp"
#include "command/report_scene.hpp"
#include "command/volume_picture.hpp"
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
Json without_folders(Json joint, std::span<const std::filesystem::path> files) {
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

ReportParts parts_of(const SessionJoint& joint, const ReportRequest& request, const ReportAnswer& found,
                     std::span<const std::filesystem::path> inputs) {
  ReportParts parts{.ball = inputs[0].filename().string(), .socket = inputs[1].filename().string()};
  parts.joint = without_folders(json_of(describe(joint, {parts.ball, parts.socket})), inputs);
  parts.doubts = joint.joint.doubts;
  parts.request = json_of(request);
  parts.answer = json_of(found);
  const Json& said = parts.answer;
  parts.scene = report_scene(joint, found.gaps);
  if (const std::optional<ClockMap> map = clock_map(joint, found.gaps))
    parts.clock = clock_plot(*map, said["gaps"]);
  if (found.limits) parts.limits = limits_plot(said["limits"]);
  if (found.volume) parts.volume = volume_picture(found.volume->volume, *joint.side);
  if (found.measures) parts.measures = measures_plot(said["measures"]);
  return parts;
}

}  // namespace

std::vector<AnswerFile> report_files(const SessionJoint& joint, const ReportRequest& request,
                                     const ReportAnswer& found,
                                     std::span<const std::filesystem::path> inputs) {
  const ReportParts parts = parts_of(joint, request, found, inputs);
  std::vector<AnswerFile> files{{"report.html", report_page(parts)},
                                {"gaps.csv", gaps_csv(joint, found.gaps)}};
  if (const std::optional<ClockMap> map = clock_map(joint, found.gaps))
    files.push_back({"clock.csv", to_csv(clock_table(*map))});
  if (found.limits) files.push_back(csv_of<LimitRow>("limits.csv", found.limits->limits));
  if (found.measures) files.push_back(csv_of<MeasureRow>("measures.csv", found.measures->measures));
  for (const auto& [name, svg] :
       {std::pair("clock.svg", &parts.clock), std::pair("limits.svg", &parts.limits),
        std::pair("volume.svg", &parts.volume), std::pair("measures.svg", &parts.measures)})
    if (!svg->empty()) files.push_back({name, *svg});
  return files;
}

}  // namespace impinge
