// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/root.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include "curves/gsl_callback.hpp"

namespace impinge {
namespace {

constexpr int kMostSteps = 300;  // bisection alone needs about 60; Brent's worst case is a few times that
constexpr double kNarrowest = 4.0 * std::numeric_limits<double>::epsilon();

}  // namespace

double find_root(const std::function<double(double)>& function, double low, double high) {
  const double at_low = function(low);
  const double at_high = function(high);
  if (at_low == 0.0) return low;
  if (at_high == 0.0) return high;
  if (!(std::isfinite(at_low) && std::isfinite(at_high) && (at_low < 0.0) != (at_high < 0.0))) {
    throw std::invalid_argument("no root: the function has the same sign at both ends of the interval");
  }
  keep_gsl_quiet();
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (!solver) throw std::bad_alloc();
  GslCallback call(function);
  call.require(gsl_root_fsolver_set(solver.get(), call.get(), low, high), "root");
  for (int step = 0; step < kMostSteps; ++step) {
    call.require(gsl_root_fsolver_iterate(solver.get()), "root");
    const double from = gsl_root_fsolver_x_lower(solver.get());
    const double to = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(from, to, 0.0, kNarrowest) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

}  // namespace impinge
