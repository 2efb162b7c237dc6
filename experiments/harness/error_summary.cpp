// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/error_summary.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace impinge::lab {

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
