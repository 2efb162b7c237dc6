// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "files/rows.hpp"
#include "joint/measures.hpp"

namespace impinge {
namespace {

// Such as "; published: mean 40.9, sd 7 (Hack 2010)"; empty if nothing is published.
std::string published_text(const PublishedMeasure& published) {
  if (published.source.empty()) return "";
  const std::string numbers = published.mean
                                  ? formatted("mean %.4g, sd %.2g", *published.mean, *published.sd)
                                  : formatted("median %.4g, quartiles %.4g and %.4g", *published.median,
                                              *published.lower_quartile, *published.upper_quartile);
  const std::string_view author = published.source.substr(0, published.source.find(','));
  return "; published: " + numbers + " (" + std::string(author) + ")";
}

std::string words_of_row(const MeasureRow& row) {
  std::string line = row.name;
  line.resize(std::max(line.size() + 1, std::size_t{20}), ' ');
  const std::string unit = row.unit == "1" ? "" : " " + row.unit;
  line += row.value ? formatted("%.3g +- %.2g", *row.value, *row.uncertainty) + unit : row.state;
  return line + published_text(row.published) + "\n";
}

Told told(Session& session, const MeasureRequest& request, const Work& /*work*/) {
  const MeasureAnswer found = answer(session, request);
  Told told{.document = json_of(found), .table_name = "measures.csv"};
  told.table.columns = columns_of<MeasureRow>();
  for (const MeasureRow& row : found.measures) {
    told.words += words_of_row(row);
    told.table.add_row(cells_of(row));
  }
  return told;
}

}  // namespace

QuestionCommand measure_question() {
  return question_of<MeasureRequest, MeasureAnswer>(
      "measure",
      "Radii, offset, neck-shaft angle, torsion, alpha, version, coverage and other measures, beside "
      "published ones.",
      "femur.ply pelvis.ply --side right", &told);
}

}  // namespace impinge
