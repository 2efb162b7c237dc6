// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/family.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>

namespace impinge::lab {
namespace {

void keep_larger(double& largest, double value) {
  if (value > largest || largest != largest) largest = value;
}

// The error as a share of its bound.
// An infinite bound, or one that no look-up tests, is worse than any that holds.
double share_of_bound(const StabilityCase& c) {
  if (!std::isnan(c.bound_um) && !c.bound_holds()) return 1.0;
  return c.bound_um > 0.0 ? c.error_um / c.bound_um : c.error_um > 0.0 ? 1e300 : 0.0;
}

void add(StabilityCase& sum, const StabilityCase& other) {
  sum.questions += other.questions;
  keep_larger(sum.condition, other.condition);
  keep_larger(sum.relative_error, other.relative_error);
  keep_larger(sum.error_over_condition_u, other.error_over_condition_u);
  keep_larger(sum.backward_error_over_u, other.backward_error_over_u);
  keep_larger(sum.stiffness, other.stiffness);
  sum.nan += other.nan;
  sum.false_hits += other.false_hits;
  sum.missed_hits += other.missed_hits;
  sum.wrong += other.wrong;
  sum.withheld += other.withheld;
  sum.unbounded += other.unbounded;
  if (sum.refused.empty()) sum.refused = other.refused;
  if (share_of_bound(other) > share_of_bound(sum)) {
    sum.bound_um = other.bound_um;
    sum.error_um = other.error_um;
  }
}

constexpr std::size_t kLeastMagnitudes = 5;

const std::vector<Column> kKey{{"family", "", "see stability_families.csv"},
                               {"magnitude", "", "of the parameter, in the unit of the family"},
                               {"method", "", "SCHEME, SCHEME_mesh_exact, cone_rays (ours), or by library"},
                               {"precision_deg", "deg", "of a table or of steps; 0: exact"},
                               {"scalar", "", "float or double: what the answers are computed or stored in"}};

std::vector<Column> with_key(const std::vector<Column>& more) {
  std::vector<Column> columns = kKey;
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

std::vector<Cell> row_of(const StabilityFamily& family, const StabilityCase& c, std::vector<Cell> more) {
  std::vector<Cell> row{family.name, c.magnitude, c.method, c.precision_deg, name_of(c.scalar)};
  row.insert(row.end(), more.begin(), more.end());
  return row;
}

// A refused case has no counts: its cells are empty, not 0.
Cell count(const StabilityCase& c, std::size_t number) { return c.refused.empty() ? Cell(number) : Cell(); }

Cell flag(const std::optional<bool>& value) { return value ? Cell(*value) : Cell(); }

void add_case(const StabilityFamily& family, const StabilityCase& c, StabilityTables& tables) {
  tables.main.add_row(row_of(family, c,
                             {c.condition, c.relative_error, c.error_over_condition_u, count(c, c.failures()),
                              flag(c.bound_holds())}));
  tables.detail.add_row(
      row_of(family, c,
             {c.kind, c.threshold, c.backward_error_over_u, c.stiffness, count(c, c.questions),
              count(c, c.nan), count(c, c.false_hits), count(c, c.missed_hits), count(c, c.wrong),
              count(c, c.withheld), count(c, c.unbounded), !c.refused.empty(), c.refused, c.error_um,
              c.kind == "mutated" ? kNotMeasured : c.bound_um}));
}

// Largest error over condition and unit roundoff; NaN without cases.
double worst_of_ours(const std::vector<StabilityCase>& cases, Scalar scalar) {
  double worst = kNotMeasured;
  for (const StabilityCase& c : cases)
    if (c.kind == "ours" && c.scalar == scalar) worst = std::fmax(worst, c.error_over_condition_u);
  return worst;
}

// Failures of cases that are wrong on purpose.
std::size_t noticed(const std::vector<StabilityCase>& cases) {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [](const StabilityCase& c) {
    return c.kind == "mutated" && (c.failures() > 0 || !c.bound_holds().value_or(true));
  }));
}

}  // namespace

std::string_view name_of(Scalar scalar) { return scalar == Scalar::float32 ? "float" : "double"; }

double unit_roundoff(Scalar scalar) { return scalar == Scalar::float32 ? 0x1p-24 : 0x1p-53; }

std::optional<bool> StabilityCase::bound_holds() const {
  if (!(bound_um >= 0.0) || std::isinf(bound_um) || std::isnan(error_um)) return std::nullopt;
  return error_um <= bound_um;
}

std::vector<StabilityCase> worse_of(std::vector<StabilityCase> a, const std::vector<StabilityCase>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i >= b.size() || a[i].method != b[i].method || a[i].scalar != b[i].scalar ||
        a[i].precision_deg != b[i].precision_deg)
      throw std::logic_error("cases of two scenes are not those of the same methods: " + a[i].method);
    add(a[i], b[i]);
  }
  return a;
}

std::vector<std::string> broken(const StabilityFamily& family, const std::vector<StabilityCase>& cases,
                                double least_share_of_seen) {
  std::vector<std::string> lines;
  for (const Scalar scalar : {Scalar::float64, Scalar::float32}) {
    const double worst = worst_of_ours(cases, scalar);
    const double seen = family.seen.at(scalar == Scalar::float64 ? 0 : 1);
    if (worst < least_share_of_seen * seen)
      lines.push_back(family.name + ": `seen` in " + std::string(name_of(scalar)) + " is above the worst, " +
                      std::to_string(worst));
  }
  if (noticed(cases) == 0)
    lines.push_back(family.name + ": no case notices the mutation, " + family.mutation);
  for (const StabilityCase& c : cases) {
    const bool bound_holds = c.bound_holds().value_or(true);
    const double most = 2.0 * family.seen.at(c.scalar == Scalar::float64 ? 0 : 1);
    const bool grown = c.error_over_condition_u > most;
    if (c.kind != "ours" || (c.failures() == 0 && bound_holds && !grown)) continue;
    std::ostringstream line;
    line << family.name << " at " << c.magnitude << " " << family.unit << ", " << c.method << " in "
         << name_of(c.scalar) << ": " << c.nan << " no numbers, " << c.false_hits << " false hits, "
         << c.missed_hits << " missed hits, " << c.wrong << " wrong (error " << c.error_over_condition_u
         << " of condition times unit roundoff, allowed " << c.threshold << ")";
    if (grown) line << ", error above " << most << ", twice `seen` of the family";
    if (!bound_holds) line << ", error " << c.error_um << " um above the bound " << c.bound_um << " um";
    lines.push_back(line.str());
  }
  return lines;
}

StabilityTables make_stability_tables() {
  StabilityTables tables;
  tables.main.columns = with_key(
      {{"condition", "1",
        "largest over the questions, of tan psi and of the plane, see measure.hpp; or as the family says"},
       {"relative_error", "1", "largest; of a table at its entries"},
       {"error_over_condition_u", "1", "largest, u the unit roundoff of the scalar"},
       {"failures", "1",
        "answers that are no numbers, false hits, missed hits and wrong values; empty if refused"},
       {"bound_holds", "",
        "is no look-up between entries farther off than proven? Empty: no bound, an infinite one, or no "
        "look-up that answers"}});
  tables.detail.columns = with_key(
      {{"kind", "", "ours, library, brute, thesis, steps, or mutated: wrong on purpose"},
       {"threshold", "1", "error_over_condition_u above it is wrong"},
       {"backward_error_over_u", "1",
        "largest relative error over tan psi and u, where tan psi is 1 or more"},
       {"stiffness", "1", "largest tan psi of the scene over its median"},
       {"questions", "1", "entries that were read and directions that were asked"},
       {"nan", "1", "answers that are no numbers or no lengths"},
       {"false_hits", "1", "answers where there is no surface"},
       {"missed_hits", "1", "no answer where there is one, those withheld aside"},
       {"wrong", "1", "errors above the threshold, or bits that should be the same and are not"},
       {"withheld", "1", "look-ups left unanswered since a rim crosses their cell; unknown contacts"},
       {"unbounded", "1", "look-ups that answer and have no finite bound"},
       {"refused", "", "was the case refused, as documented?"},
       {"refusal", "", "the line of the refusal"},
       {"error_um", "um",
        "of the look-up between entries that is nearest to its bound; empty if none answers"},
       {"bound_um", "um", "proven bound on it"}});
  tables.families.columns = {
      {"family", "", "file in experiments/stress/families"},
      {"parameter", "", "what is varied"},
      {"unit", "", "of the magnitudes"},
      {"magnitudes", "1", "how many"},
      {"expected", "", "of ours, stated before the run"},
      {"threshold", "1", "on error_over_condition_u of ours in double"},
      {"derivation", "", "of the threshold"},
      {"seen", "1",
       "largest error_over_condition_u of ours in double before, rounded down: a run "
       "breaks on twice as much"},
      {"seen_in_float", "1", "the same of ours stored in float"},
      {"mutation", "", "what is wrong with the method of kind mutated"},
      {"mutation_cases", "1", "its cases"},
      {"mutation_noticed", "1", "those of them that fail"},
      {"cases", "1", "methods at magnitudes, of ours"},
      {"refused", "1", "of those"},
      {"broken", "1", "of those: failures outside of what is refused, and errors above twice what was seen"}};
  return tables;
}

void run_family(const StabilityFamily& family, const StabilityRun& run, StabilityTables& tables) {
  const std::vector<StabilityCase> cases = family.run(run);
  std::set<double> magnitudes;
  std::size_t ours = 0;
  std::size_t refused = 0;
  std::size_t mutated = 0;
  for (const StabilityCase& c : cases) {
    magnitudes.insert(c.magnitude);
    ours += c.kind == "ours" ? 1U : 0U;
    mutated += c.kind == "mutated" ? 1U : 0U;
    refused += c.kind == "ours" && !c.refused.empty() ? 1U : 0U;
    add_case(family, c, tables);
  }
  if (magnitudes.size() < kLeastMagnitudes)
    throw std::logic_error("family " + family.name + " has fewer than 5 magnitudes: add some");
  const std::vector<std::string> lines = broken(family, cases, run.quick ? kQuickShareOfSeen : 1.0);
  tables.broken.insert(tables.broken.end(), lines.begin(), lines.end());
  tables.families.add_row({family.name, family.parameter, family.unit, magnitudes.size(), family.expected,
                           family.threshold, family.derivation, family.seen[0], family.seen[1],
                           family.mutation, mutated, noticed(cases), ours, refused, lines.size()});
}

StabilityTables run_stability(const StabilityRun& run, Progress& progress) {
  StabilityTables tables = make_stability_tables();
  const std::vector<StabilityFamily> families = stability_families();
  progress.begin(static_cast<double>(families.size()));
  for (const StabilityFamily& family : families) {
    run_family(family, run, tables);
    progress.advance(1.0, family.name);
  }
  return tables;
}

}  // namespace impinge::lab
