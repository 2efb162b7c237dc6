// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/family.hpp"

#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace impinge::lab {
namespace {

void keep_larger(double& largest, double value) {
  if (value > largest || largest != largest) largest = value;
}

// How near the error is to its bound.
double share_of_bound(const StabilityCase& c) {
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
  if (sum.refused.empty()) sum.refused = other.refused;
  if (share_of_bound(other) > share_of_bound(sum)) {
    sum.bound_um = other.bound_um;
    sum.error_um = other.error_um;
  }
}

}  // namespace

std::string_view name_of(Scalar scalar) { return scalar == Scalar::float32 ? "float" : "double"; }

double unit_roundoff(Scalar scalar) { return scalar == Scalar::float32 ? 0x1p-24 : 0x1p-53; }

std::optional<bool> StabilityCase::bound_holds() const {
  if (!(bound_um >= 0.0)) return std::nullopt;
  return !(error_um > bound_um);  // no look-up answered: nothing is violated
}

std::vector<StabilityCase> worse_of(std::vector<StabilityCase> a, const std::vector<StabilityCase>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i >= b.size() || a[i].method != b[i].method || a[i].scalar != b[i].scalar)
      throw std::logic_error("cases of two scenes are not those of the same methods: " + a[i].method);
    add(a[i], b[i]);
  }
  return a;
}

std::vector<std::string> broken(const StabilityFamily& family, const std::vector<StabilityCase>& cases) {
  std::vector<std::string> lines;
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

}  // namespace impinge::lab
