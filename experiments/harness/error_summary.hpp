// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of many errors.
#pragma once

#include <cstddef>
#include <span>

namespace impinge::lab {

// In the unit of the errors, which are not negative.
struct ErrorSummary {
  double max = 0.0;    // the largest
  double rms = 0.0;    // root mean square
  double p9999 = 0.0;  // all but one in ten thousand are below
};

// The largest of all errors; the root mean square and the quantile of the first `uniform` of them, which
// belong to directions spread evenly. Others may follow from places that were chosen, such as edges.
// std::invalid_argument for no error, an error that is no number, or more uniform ones than there are.
ErrorSummary summarise_errors(std::span<const double> errors, std::size_t uniform);
inline ErrorSummary summarise_errors(std::span<const double> errors) {
  return summarise_errors(errors, errors.size());
}

}  // namespace impinge::lab
