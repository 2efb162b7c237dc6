// SPDX-License-Identifier: GPL-3.0-or-later
// The program `impinge`.
#pragma once

#include <ostream>

namespace impinge {

/// Runs a command line. Returns the exit code: 0 on success, 1 where a mesh or file cannot be used, 2 for a
/// wrong command or option. Answers go to `out`; warnings, progress and the one line of an error to `log`.
int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& log);

}  // namespace impinge
