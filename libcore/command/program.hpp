// SPDX-License-Identifier: GPL-3.0-or-later
// The program `impinge`.
#pragma once

#include <functional>
#include <ostream>
#include <span>

#include "command/joint_command.hpp"

namespace impinge {

/// Adds a command; if it is given, it sets `work` to what it will do.
using AddCommand = void (*)(CLI::App& program, const Screen& screen, std::function<void()>& work);

/// Reads a command line and returns a function that does what it asks for; none if there is no command.
/// Prints the text of --help and --version. Throws CommandError, one line. Reads no mesh.
std::function<void()> parse_program(int argc, const char* const* argv, const Screen& screen,
                                    std::span<const AddCommand> more = {});

/// Runs a command line. Returns the exit code: 0 for success, 1 if a mesh or file cannot be used, 2 for a
/// wrong command or option. Answers go to `out`; warnings, progress and the one line of an error go to `log`.
/// `more` are commands from outside this folder.
int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& log,
                std::span<const AddCommand> more = {});

}  // namespace impinge
