// SPDX-License-Identifier: GPL-3.0-or-later
// How the columns of a grid are often numbered, beside the ways of our schemes: azimuths in degrees as
// floats, and azimuths that are summed step by step. Errors are angles in radians; two neighbours at one
// azimuth are wrong.
#pragma once

#include "stress/family.hpp"

namespace impinge::lab {

// The last hundred columns of a row, step degrees apart. A step divides 360.
StabilityCase float_azimuths(double step, double threshold);

// Each thousandth of the first million columns, in double.
StabilityCase summed_azimuths(double step, double threshold);

}  // namespace impinge::lab
