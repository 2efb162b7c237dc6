// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/quadrature.hpp"

#include <memory>
#include <new>

#include <gsl/gsl_integration.h>

#include "curves/gsl_callback.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostIntervals = 2000;
constexpr double kRelative = 1e-12;

}  // namespace

double integrate(const std::function<double(double)>& function, double low, double high) {
  keep_gsl_quiet();
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space(
      gsl_integration_workspace_alloc(kMostIntervals), gsl_integration_workspace_free);
  if (!space) throw std::bad_alloc();
  GslCallback call(function);
  double value = 0.0;
  double error = 0.0;
  double size = 0.0;  // of |function|, so that an integral that vanishes has a tolerance too
  double deviation = 0.0;
  gsl_integration_qk61(call.get(), low, high, &value, &error, &size, &deviation);
  const int status = gsl_integration_qag(call.get(), low, high, kRelative * size, kRelative, kMostIntervals,
                                         GSL_INTEG_GAUSS61, space.get(), &value, &error);
  call.require(status, "integral");
  return value;
}

}  // namespace impinge
