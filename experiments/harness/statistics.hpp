// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics of repeated measurements.
#pragma once

#include <cstddef>
#include <span>

namespace impinge::lab {

// Quantile p in [0, 1] of samples in any order, by linear interpolation of the order statistics at (n - 1) p:
// type 7 of Hyndman and Fan (1996), the default of R and NumPy. NaN without samples.
double quantile(std::span<const double> samples, double p);

// Median and spread of samples.
struct Summary {
  double median = 0.0;    // unit of the samples
  double iqr = 0.0;       // third minus first quartile; 0 for one sample
  std::size_t count = 0;  // number of samples
};

Summary summarise(std::span<const double> samples);  // NaN and 0 without samples

// Summary statistics of many errors.

// In the unit of the errors, which must not be negative.
struct ErrorSummary {
  double max = 0.0;  // the largest
  double rms = 0.0;  // root mean square
};

// The maximum is over all errors. The root mean square is over the first `uniform` of them, which belong to
// evenly spread directions; the others may be from chosen places, such as edges. Throws std::invalid_argument
// without errors, for NaN, and for `uniform` above their number.
ErrorSummary summarise_errors(std::span<const double> errors, std::size_t uniform);
inline ErrorSummary summarise_errors(std::span<const double> errors) {
  return summarise_errors(errors, errors.size());
}

}  // namespace impinge::lab
