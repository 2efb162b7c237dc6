// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/algorithm_2.hpp"

#include <cmath>

namespace impinge::lab {

ScanVerdicts compare_as_written(std::span<const double> gap, Surface scanned) {
  ScanVerdicts verdicts;
  for (const double g : gap) {
    if (std::isnan(g)) continue;
    ++verdicts.met;
    if (g <= 0.0) ++verdicts.by_gap;
    if (scanned == Surface::ball ? g <= 0.0 : g >= 0.0) ++verdicts.as_written;
  }
  return verdicts;
}

}  // namespace impinge::lab
