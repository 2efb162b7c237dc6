// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include <gsl/gsl_cdf.h>

#include "cohort/answers.hpp"
#include "files/finite_number.hpp"
#include "harness/statistics.hpp"
#include "limits/turn_limit.hpp"

namespace impinge::lab {
namespace {

using nlohmann::json;

constexpr std::array kShares{0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 0.975, 0.99};
constexpr double kTail = 0.025;  // beyond each end of an interval of 95 %
constexpr std::string_view kState = "_state";
constexpr double kMeshShare = 0.95;  // of the checked hips: their change with the mesh widens an interval

// The cells of a column: the numbers, NaN for empty cells and words; and the words.
struct ColumnValues {
  std::vector<double> numbers;
  std::map<std::string, std::size_t> words;
  std::vector<bool> limited;  // is it this word?
};

void add_cell(ColumnValues& column, std::string_view cell) {
  const std::optional<double> number = finite_number(cell);
  if (!number && !cell.empty()) ++column.words[std::string(cell)];
  column.numbers.push_back(number.value_or(NAN));
  column.limited.push_back(cell == word_of(LimitState::limited));
}

std::vector<ColumnValues> values_of(std::size_t columns, std::string_view csv) {
  std::vector<ColumnValues> values(columns);
  std::size_t k = 0;
  for (std::size_t at = 0; at < csv.size();) {
    const std::size_t end = csv.find_first_of(",\n", at);
    if (end == std::string_view::npos || k == columns) throw std::runtime_error("a row of the cohort is cut");
    add_cell(values[k++], csv.substr(at, end - at));
    if (csv[end] == '\n') {
      if (k != columns) throw std::runtime_error("a row of the cohort is cut");
      k = 0;
    }
    at = end + 1;
  }
  return values;
}

// The rows, by the names of the columns.
class Cohort {
 public:
  Cohort(const std::vector<Column>& columns, std::string_view csv) : values_(values_of(columns.size(), csv)) {
    for (std::size_t k = 0; k < columns.size(); ++k) place_[columns[k].name] = k;
    for (const auto& [name, k] : place_) {
      if (name.ends_with(kState))
        keep_limits(name.substr(0, name.size() - kState.size()), values_[k].limited);
    }
  }
  const ColumnValues* column(const std::string& name) const {
    const auto found = place_.find(name);
    return found == place_.end() ? nullptr : &values_[found->second];
  }

 private:
  // Only where a motion ended by contact have its angles, and the zones there, to do with a limit. Where that
  // is not so for every centre, the upper end is open.
  void keep_limits(const std::string& motion, const std::vector<bool>& limited) {
    for (const std::string& name :
         {motion + "_deg", motion + "_low_deg", motion + "_high_deg", motion + "_zone_from",
          motion + "_zone_to", motion + "_zone_mm2", kFine + motion + "_deg"}) {
      const auto found = place_.find(name);
      if (found == place_.end()) continue;
      std::vector<double>& numbers = values_[found->second].numbers;
      for (std::size_t j = 0; j < numbers.size(); ++j) {
        if (!limited[j])
          numbers[j] = NAN;
        else if (std::isnan(numbers[j]) && name.ends_with("_high_deg"))
          numbers[j] = INFINITY;
      }
    }
  }

  std::vector<ColumnValues> values_;
  std::map<std::string, std::size_t> place_;
};

std::vector<double> sorted_numbers(const ColumnValues& column) {
  std::vector<double> x;
  for (const double value : column.numbers) {
    if (!std::isnan(value)) x.push_back(value);
  }
  std::sort(x.begin(), x.end());
  return x;
}

// Changes by the finer mesh, in ascending order.
std::vector<double> mesh_changes(const Cohort& cohort, const std::string& name) {
  const ColumnValues* fine = cohort.column(kFine + name);
  if (fine == nullptr) return {};
  ColumnValues change;
  const std::vector<double>& coarse = cohort.column(name)->numbers;
  for (std::size_t j = 0; j < coarse.size(); ++j)
    change.numbers.push_back(std::abs(fine->numbers[j] - coarse[j]));
  return sorted_numbers(change);
}

json end_of(const std::vector<double>& sorted, std::size_t rank) {
  return rank < 1 || rank > sorted.size() ? json(nullptr) : json(sorted[rank - 1]);
}

// The states behind M_deg; null for other columns.
const ColumnValues* state_of(const Cohort& cohort, const std::string& name) {
  return name.ends_with("_deg") ? cohort.column(name.substr(0, name.size() - 4) + std::string(kState))
                                : nullptr;
}

// The lower and the upper end for each value.
struct InputEnds {
  std::vector<double> low;
  std::vector<double> high;
};

InputEnds input_ends(const Cohort& cohort, const std::string& name, const std::vector<double>& values) {
  if (name.ends_with("_deg")) {
    const std::string motion = name.substr(0, name.size() - 4);
    const ColumnValues* low = cohort.column(motion + "_low_deg");
    const ColumnValues* high = cohort.column(motion + "_high_deg");
    if (low != nullptr && high != nullptr) return {sorted_numbers(*low), sorted_numbers(*high)};
  }
  return {values, values};
}

json quantiles_of(const Cohort& cohort, const std::string& name, const std::vector<double>& sorted,
                  double mesh_change) {
  const InputEnds ends = input_ends(cohort, name, sorted);
  json list = json::array();
  for (const double p : kShares) {
    const RankInterval ranks = rank_interval(sorted.size(), p);
    list.push_back(
        {{"p", p},
         {"value", quantile(sorted, p)},
         {"sampling", {end_of(sorted, ranks.low), end_of(sorted, ranks.high)}},
         {"mesh_and_centre", {quantile(ends.low, p) - mesh_change, quantile(ends.high, p) + mesh_change}}});
  }
  return list;
}

json quantity_of(const Cohort& cohort, const std::string& name, const std::vector<double>& sorted) {
  const auto n = static_cast<double>(sorted.size());
  double sum = 0.0;
  for (const double x : sorted) sum += x;
  double squares = 0.0;
  for (const double x : sorted) squares += (x - sum / n) * (x - sum / n);
  json quantity{{"n", sorted.size()}, {"mean", sum / n}};
  if (const ColumnValues* state = state_of(cohort, name)) {
    quantity["without_limit"] = state->words;
    quantity["without_limit"].erase(word_of(LimitState::limited));
  }
  quantity["sd"] = sorted.size() > 1 ? json(std::sqrt(squares / (n - 1.0))) : json(nullptr);
  const std::vector<double> changes = mesh_changes(cohort, name);
  double change = 0.0;
  if (!changes.empty()) {
    change = quantile(changes, kMeshShare);
    quantity["mesh"] = {{"checked", changes.size()}, {"p95", change}, {"largest", changes.back()}};
  }
  quantity["quantiles"] = quantiles_of(cohort, name, sorted, change);
  return quantity;
}

// Number of hips in each hour; a circle has no quantiles.
json hours_of(const std::vector<double>& sorted) {
  std::array<std::size_t, 12> count{};
  for (const double x : sorted) ++count.at(static_cast<std::size_t>(x) % 12);
  return count;
}

bool is_on_dial(const std::string& name) {
  return name.ends_with("_clock") || name.ends_with("_zone_from") || name.ends_with("_zone_to");
}

}  // namespace

RankInterval rank_interval(std::size_t n, double p) {
  const auto draws = static_cast<unsigned>(n);
  RankInterval ranks{0, n + 1};
  // X_(l) is above the quantile if fewer than l draws are below it, X_(u) is below it if u or more are. Both
  // probabilities are monotone in the rank.
  const auto below = [&](std::size_t k) { return gsl_cdf_binomial_P(static_cast<unsigned>(k), p, draws); };
  std::size_t from = 0;
  std::size_t to = n + 1;
  while (to - from > 1) {  // largest l with P(fewer than l) <= 2.5 %
    const std::size_t middle = from + (to - from) / 2;
    (below(middle - 1) <= kTail ? from : to) = middle;
  }
  ranks.low = from;
  from = 0;
  to = n + 1;
  while (to - from > 1) {  // least u with P(u or more) <= 2.5 %
    const std::size_t middle = from + (to - from) / 2;
    (1.0 - below(middle - 1) <= kTail ? to : from) = middle;
  }
  ranks.high = to;
  return ranks;
}

json summary_of(const Study& study, const std::vector<Column>& columns, std::string_view csv) {
  const Cohort cohort(columns, csv);
  json summary{{"title", study.text["title"]},
               {"study", study.text},
               {"study_sha256", study.digest},
               {"seed", study.seed},
               {"shards", "shards.json"}};
  summary["hips"] = cohort.column("hip")->numbers.size();
  json quantities = json::object();
  json counts = json::object();
  for (const Column& column : columns) {
    summary["columns"].push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
    const std::string& name = column.name;
    if (name == "hip" || name == "joint" || name.starts_with(kFine)) continue;
    const ColumnValues& values = *cohort.column(name);
    const std::vector<double> sorted = sorted_numbers(values);
    if (!values.words.empty()) counts[name] = values.words;
    if (sorted.empty() || name.ends_with("_low_deg") || name.ends_with("_high_deg")) continue;
    if (is_on_dial(name))
      counts[name] = hours_of(sorted);
    else
      quantities[name] = quantity_of(cohort, name, sorted);
  }
  summary["quantities"] = std::move(quantities);
  summary["counts"] = std::move(counts);
  return summary;
}

}  // namespace impinge::lab
