// SPDX-License-Identifier: GPL-3.0-or-later
// Common ways to number the columns of a grid, besides those of our schemes: azimuths in degrees as floats,
// and azimuths that are summed step by step. Errors are angles in radians; neighbours with the same azimuth
// count as wrong.
#pragma once

#include "stress/family.hpp"

namespace impinge::lab {

// The last hundred columns of a row, `step` degrees apart. The step divides 360.
StabilityCase float_azimuths(double step, double threshold);

// Every thousandth of the first million columns, in double.
StabilityCase summed_azimuths(double step, double threshold);

}  // namespace impinge::lab
