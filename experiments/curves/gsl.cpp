// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/gsl.hpp"

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_mode.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_sf_ellint.h>

namespace impinge {
namespace {

constexpr int kMostSteps = 300;  // bisection alone needs about 60; Brent's worst case is a few times that
constexpr double kNarrowest = 4.0 * std::numeric_limits<double>::epsilon();

constexpr std::size_t kMostIntervals = 2000;
constexpr double kRelative = 1e-12;

// Switches off GSL's own error handler, which would end the program. It does so once for the whole program
// and for good, since restoring it would race with other threads. Even functions with the suffix _e call it.
void keep_gsl_quiet() {
  static const auto previous = gsl_set_error_handler_off();
  static_cast<void>(previous);
}

// Throws std::runtime_error "what: GSL's reason" unless status is GSL_SUCCESS.
void require_gsl(int status, const std::string& what) {
  if (status != GSL_SUCCESS) throw std::runtime_error(what + ": " + gsl_strerror(status));
}

// A C++ function as a gsl_function. An exception must not pass through C code, so it is kept here.
class GslCallback {
 public:
  // The function must live as long as this object.
  explicit GslCallback(const std::function<double(double)>& function) : function_(function) {}
  GslCallback(const GslCallback&) = delete;  // GSL keeps the address
  GslCallback& operator=(const GslCallback&) = delete;

  gsl_function* get() { return &wrapped_; }  // for GSL, while this object lives

  // Throws what the function threw, else what GSL's status says.
  void require(int status, const char* what) const {
    if (thrown_) std::rethrow_exception(thrown_);
    require_gsl(status, what);
  }

 private:
  static double evaluate(double x, void* self) {
    auto& call = *static_cast<GslCallback*>(self);
    try {
      return call.function_(x);
    } catch (...) {
      call.thrown_ = std::current_exception();
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

  const std::function<double(double)>& function_;
  std::exception_ptr thrown_;
  gsl_function wrapped_{evaluate, this};
};

}  // namespace

double gsl_carlson_rf(double x, double y, double z) {
  keep_gsl_quiet();
  gsl_sf_result result;
  require_gsl(gsl_sf_ellint_RF_e(x, y, z, GSL_PREC_DOUBLE, &result), "elliptic integral R_F");
  return result.val;
}

double gsl_carlson_rd(double x, double y, double z) {
  keep_gsl_quiet();
  gsl_sf_result result;
  require_gsl(gsl_sf_ellint_RD_e(x, y, z, GSL_PREC_DOUBLE, &result), "elliptic integral R_D");
  return result.val;
}

double arc_of_growing_speed(double phi, double n) {
  const double sine = std::sin(phi);
  if (sine == 0.0) return 0.0;
  const double square = sine * sine;
  const double cosine = std::cos(phi);
  const double speed = 1.0 + n * square;
  return sine * (gsl_carlson_rf(cosine * cosine, speed, 1.0) +
                 n / 3.0 * square * gsl_carlson_rd(cosine * cosine, speed, 1.0));
}

double arc_of_falling_speed(double phi, double rest) {
  const double sine = std::sin(phi);
  if (sine == 0.0) return 0.0;
  const double square = sine * sine;
  const double cosine = std::cos(phi);
  const double m = 1.0 - rest;
  const double speed = cosine * cosine + rest * square;  // 1 - m sin^2, no cancellation
  const double carlson = gsl_carlson_rf(cosine * cosine, speed, 1.0) +
                         m / 3.0 * square * gsl_carlson_rd(cosine * cosine, 1.0, speed);
  return sine * (rest * carlson + m * cosine / std::sqrt(speed));
}

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

double integrate(const std::function<double(double)>& function, double low, double high) {
  keep_gsl_quiet();
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space(
      gsl_integration_workspace_alloc(kMostIntervals), gsl_integration_workspace_free);
  if (!space) throw std::bad_alloc();
  GslCallback call(function);
  double value = 0.0;
  double error = 0.0;
  double size = 0.0;  // integral of |function|, so that an integral that vanishes has a tolerance too
  double deviation = 0.0;
  gsl_integration_qk61(call.get(), low, high, &value, &error, &size, &deviation);
  const int status = gsl_integration_qag(call.get(), low, high, kRelative * size, kRelative, kMostIntervals,
                                         GSL_INTEG_GAUSS61, space.get(), &value, &error);
  call.require(status, "integral");
  return value;
}

}  // namespace impinge
