// SPDX-License-Identifier: GPL-3.0-or-later
// A C++ function as a gsl_function. An exception must not pass through C code: it waits here.
#pragma once

#include <exception>
#include <functional>
#include <limits>

#include <gsl/gsl_math.h>

#include "curves/gsl_errors.hpp"

namespace impinge {

class GslCallback {
 public:
  /// The function must live as long as this object.
  explicit GslCallback(const std::function<double(double)>& function) : function_(function) {}
  GslCallback(const GslCallback&) = delete;  // GSL keeps the address
  GslCallback& operator=(const GslCallback&) = delete;

  gsl_function* get() { return &wrapped_; }  // to hand to GSL, as long as this object lives

  /// Throws what the function threw, else what GSL's status says.
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

}  // namespace impinge
