// SPDX-License-Identifier: GPL-3.0-or-later
// One question more in a case whose answers are numbers of any kind.
#pragma once

#include <cmath>

#include "stress/family.hpp"

namespace impinge::lab {

// error: relative to the truth; not finite where the answer was no number. The threshold of the case is set.
inline void include_error(StabilityCase& result, double error, double condition) {
  ++result.questions;
  if (!std::isfinite(error)) {
    ++result.nan;
    return;
  }
  const double share = error / (condition * unit_roundoff(result.scalar));
  result.condition = std::fmax(result.condition, condition);  // of a NaN and a number the number
  result.relative_error = std::fmax(result.relative_error, error);
  result.error_over_condition_u = std::fmax(result.error_over_condition_u, share);
  if (share > result.threshold) ++result.wrong;
}

}  // namespace impinge::lab
