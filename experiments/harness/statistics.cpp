// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace impinge::lab {

double quantile(std::span<const double> samples, double p) {
  if (samples.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  const double position = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double share = position - static_cast<double>(below);
  return sorted[below] + share * (sorted[above] - sorted[below]);
}

Summary summarise(std::span<const double> samples) {
  return {quantile(samples, 0.5), quantile(samples, 0.75) - quantile(samples, 0.25), samples.size()};
}

ErrorSummary summarise_errors(std::span<const double> errors, std::size_t uniform) {
  if (uniform == 0 || uniform > errors.size()) {
    throw std::invalid_argument(
        "errors are summarised over one uniform direction or more, and no more than there are");
  }
  if (!std::ranges::all_of(errors, [](double e) { return e >= 0.0; })) {
    throw std::invalid_argument("an error is no number: leave out directions in which there is no surface");
  }
  double squares = 0.0;
  for (const double e : errors.first(uniform)) squares += e * e;
  return {*std::ranges::max_element(errors), std::sqrt(squares / static_cast<double>(uniform))};
}

}  // namespace impinge::lab
