// SPDX-License-Identifier: GPL-3.0-or-later
// The program `impinge`.
#pragma once

#include <functional>
#include <ostream>
#include <span>

#include "command/joint_command.hpp"

namespace impinge {

/// Adds a command, which sets `work` to what it will do.
using AddCommand = void (*)(CLI::App& program, const Screen& screen, std::function<void()>& work);

/// Reads a command line and returns what will do what it asks for; none if there is no command. The text that
/// --help and --version ask for is printed. CommandError, one line. No mesh is read.
std::function<void()> parse_program(int argc, const char* const* argv, const Screen& screen,
                                    std::span<const AddCommand> more = {});

/// Runs a command line. Returns the exit code: 0 on success, 1 where a mesh or file cannot be used, 2 for a
/// wrong command or option. Answers go to `out`; warnings, progress and the one line of an error to `log`.
/// `more` are commands beside those of this folder.
int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& log,
                std::span<const AddCommand> more = {});

}  // namespace impinge
