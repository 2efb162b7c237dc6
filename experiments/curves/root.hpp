// SPDX-License-Identifier: GPL-3.0-or-later
// Roots in an interval (GSL, Brent's method).
#pragma once

#include <functional>

namespace impinge {

/// A root of a continuous function that does not have the same sign at both ends, to a few units of the last
/// digit of the root. std::invalid_argument where the signs are the same or a value is not finite;
/// an exception of the function comes through.
double find_root(const std::function<double(double)>& function, double low, double high);

}  // namespace impinge
