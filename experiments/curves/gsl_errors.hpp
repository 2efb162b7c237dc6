// SPDX-License-Identifier: GPL-3.0-or-later
// GSL's errors as exceptions. GSL's own handler ends the program, and functions with the suffix _e call it
// too.
#pragma once

#include <string>

namespace impinge {

/// Switches GSL's handler off, once for the whole program and for good: setting it back would race with other
/// threads. Every use of GSL in this folder calls it first.
void keep_gsl_quiet();

/// Throws std::runtime_error "what: GSL's reason" unless status is GSL_SUCCESS.
void require_gsl(int status, const std::string& what);

}  // namespace impinge
