// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_table.hpp"

#include <algorithm>

#include "gap/formatted.hpp"
#include "scene/asked.hpp"

namespace impinge {
namespace {

nlohmann::json number_json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nullptr;
}

Cell number_cell(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

}  // namespace

Table measure_table() {
  Table table;
  table.columns = {{"joint", "", "its folder, or empty"},
                   {"measure", "", "its name"},
                   {"value", "", "in `unit`; empty where it is refused"},
                   {"uncertainty", "", "in `unit`: how far it moves when it is measured otherwise"},
                   {"unit", "", "mm, deg or 1"},
                   {"state", "", "measured, or refused and why"}};
  return table;
}

void add_measure_rows(const std::string& joint, const std::vector<Measure>& measures, Table& table) {
  for (const Measure& m : measures)
    table.add_row({joint, m.name, number_cell(m.value), number_cell(m.uncertainty), m.unit, m.state});
}

nlohmann::json measures_summary(const SceneOptions& options, const SessionJoint& joint,
                                const std::vector<Measure>& measures) {
  nlohmann::json report = asked_json(options, joint.joint);
  report["measures"] = nlohmann::json::array();
  for (const Measure& m : measures) {
    report["measures"].push_back({{"measure", m.name},
                                  {"value", number_json(m.value)},
                                  {"uncertainty", number_json(m.uncertainty)},
                                  {"unit", m.unit},
                                  {"state", m.state}});
  }
  return report;
}

std::string describe_measures(const std::vector<Measure>& measures) {
  std::string text;
  for (const Measure& m : measures) {
    std::string line = m.name;
    line.resize(std::max(line.size() + 1, std::size_t{20}), ' ');
    const std::string unit = m.unit == "1" ? "" : " " + m.unit;
    text += line;
    text += m.value ? formatted("%.3g +- %.2g", *m.value, *m.uncertainty) + unit : m.state;
    text += "\n";
  }
  return text;
}

}  // namespace impinge
