// SPDX-License-Identifier: GPL-3.0-or-later
// Summary statistics of many errors.
#pragma once

#include <cstddef>
#include <span>

namespace impinge::lab {

// In the unit of the errors, which are not negative.
struct ErrorSummary {
  double max = 0.0;  // the largest
  double rms = 0.0;  // root mean square
};

// The maximum is over all errors; the root mean square is over the first `uniform` of them, which
// belong to directions spread evenly (the rest may be from chosen places, such as edges).
// std::invalid_argument for no errors, an error that is NaN, or `uniform` above their number.
ErrorSummary summarise_errors(std::span<const double> errors, std::size_t uniform);
inline ErrorSummary summarise_errors(std::span<const double> errors) {
  return summarise_errors(errors, errors.size());
}

}  // namespace impinge::lab
