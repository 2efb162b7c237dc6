// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_table.hpp"

#include <algorithm>

#include "files/formatted.hpp"
#include "hip/published_measures.hpp"
#include "scene/asked.hpp"

namespace impinge {
namespace {

nlohmann::json optional_json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nullptr;
}

Cell number_cell(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

nlohmann::json text_json(std::string_view text) { return text.empty() ? nlohmann::json() : text; }

// As "; published: mean 40.9, sd 7 (Hack 2010)"; empty where nothing is.
std::string published_text(const PublishedMeasure& published) {
  if (published.source.empty()) return "";
  const std::string numbers = published.mean
                                  ? formatted("mean %.4g, sd %.2g", *published.mean, *published.sd)
                                  : formatted("median %.4g, quartiles %.4g and %.4g", *published.median,
                                              *published.lower_quartile, *published.upper_quartile);
  const std::string_view author = published.source.substr(0, published.source.find(','));
  return "; published: " + numbers + " (" + std::string(author) + ")";
}

}  // namespace

Table measure_table() {
  Table table;
  table.columns = {{"joint", "", "its folder, or empty"},
                   {"measure", "", "its name"},
                   {"value", "", "in `unit`; empty where it is refused"},
                   {"uncertainty", "", "in `unit`: how far it moves when it is measured otherwise"},
                   {"unit", "", "mm, deg or 1"},
                   {"state", "", "measured, or refused and why"},
                   {"published_mean", "", "in `unit`, of a population; empty without a source"},
                   {"published_sd", "", "in `unit`: standard deviation"},
                   {"published_median", "", "in `unit`, where the source has one in place of a mean"},
                   {"published_lower_quartile", "", "in `unit`"},
                   {"published_upper_quartile", "", "in `unit`"},
                   {"published_of", "", "the group, and how it was measured"},
                   {"published_source", "", "where"}};
  return table;
}

void add_measure_rows(const std::string& joint, const std::vector<MeasureRow>& measures, Table& table) {
  for (const MeasureRow& m : measures) {
    const PublishedMeasure published = published_measure(m.measure);
    table.add_row({joint, m.measure, number_cell(m.value), number_cell(m.uncertainty), m.unit, m.state,
                   number_cell(published.mean), number_cell(published.sd), number_cell(published.median),
                   number_cell(published.lower_quartile), number_cell(published.upper_quartile), published.of,
                   published.source});
  }
}

nlohmann::json measures_summary(const SceneOptions& options, const SessionJoint& joint,
                                const std::vector<MeasureRow>& measures) {
  nlohmann::json report = asked_json(options, joint.joint);
  report["measures"] = nlohmann::json::array();
  for (const MeasureRow& m : measures) {
    const PublishedMeasure published = published_measure(m.measure);
    report["measures"].push_back({{"measure", m.measure},
                                  {"value", optional_json(m.value)},
                                  {"uncertainty", optional_json(m.uncertainty)},
                                  {"unit", m.unit},
                                  {"state", m.state},
                                  {"published_mean", optional_json(published.mean)},
                                  {"published_sd", optional_json(published.sd)},
                                  {"published_median", optional_json(published.median)},
                                  {"published_lower_quartile", optional_json(published.lower_quartile)},
                                  {"published_upper_quartile", optional_json(published.upper_quartile)},
                                  {"published_of", text_json(published.of)},
                                  {"published_source", text_json(published.source)}});
  }
  return report;
}

std::string describe_measures(const std::vector<MeasureRow>& measures) {
  std::string text;
  for (const MeasureRow& m : measures) {
    std::string line = m.measure;
    line.resize(std::max(line.size() + 1, std::size_t{20}), ' ');
    const std::string unit = m.unit == "1" ? "" : " " + m.unit;
    text += line;
    text += m.value ? formatted("%.3g +- %.2g", *m.value, *m.uncertainty) + unit : m.state;
    text += published_text(published_measure(m.measure));
    text += "\n";
  }
  return text;
}

}  // namespace impinge
