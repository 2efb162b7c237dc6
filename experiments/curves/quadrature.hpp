// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals of smooth functions (GSL, adaptive Gauss-Kronrod).
#pragma once

#include <functional>

namespace impinge {

/// The integral from low to high, to 1e-12 of the integral of |function|. std::runtime_error where that is
/// not reached; an exception of the function comes through.
double integrate(const std::function<double(double)>& function, double low, double high);

}  // namespace impinge
