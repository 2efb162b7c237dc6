// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/files.hpp"

#include <string>

#include "files/rows.hpp"
#include "joint/joint_files.hpp"
#include "report/clock.hpp"
#include "report/page.hpp"

namespace impinge {
namespace {

// The CSV as the question alone writes it; its first column is only for many joints.
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

// Gives files by their names alone, so that the bytes do not depend on the folder.
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

}  // namespace

std::vector<AnswerFile> report_files(const SessionJoint& joint, const ReportRequest& request,
                                     const ReportAnswer& found,
                                     std::span<const std::filesystem::path> inputs) {
  ReportParts parts =
      report_parts(joint, {.ball = inputs[0].filename().string(), .socket = inputs[1].filename().string()},
                   request, found);
  parts.joint = without_folders(parts.joint, inputs);
  parts.program = std::string("impinge ") + kVersion + ", commit " + commit();
  parts.viewer = kReportViewer;
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
