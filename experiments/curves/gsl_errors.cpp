// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/gsl_errors.hpp"

#include <stdexcept>

#include <gsl/gsl_errno.h>

namespace impinge {

void keep_gsl_quiet() {
  static const auto previous = gsl_set_error_handler_off();
  static_cast<void>(previous);
}

void require_gsl(int status, const std::string& what) {
  if (status != GSL_SUCCESS) throw std::runtime_error(what + ": " + gsl_strerror(status));
}

}  // namespace impinge
