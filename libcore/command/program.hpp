// SPDX-License-Identifier: GPL-3.0-or-later
// The program `impinge` and its commands: those that ask a question about a joint, or about all joints of a
// folder, and the others.
#pragma once

#include <exception>
#include <functional>
#include <ostream>
#include <span>
#include <stdexcept>

#include <CLI/CLI.hpp>

namespace impinge {

/// Where a command writes.
struct Screen {
  std::ostream& out;
  std::ostream& log;
};

/// The error line when there is no memory left to compose one.
inline constexpr const char* kNoMemory =
    "there is not enough memory; choose a coarser --precision or smaller meshes";

/// What is wrong with a command line, and where to look; what() is one line.
class CommandError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Another program has already said why; only its exit code remains.
struct Refused : std::exception {
  explicit Refused(int with) : code(with) {}
  int code;
};

/// Adds each question (command/question_command.hpp) as a command. The command that is given sets `work` to
/// what it will do.
void add_joint_commands(CLI::App& program, const Screen& screen, std::function<void()>& work);

/// `impinge hip`: meshes of a hip from parameters.
void add_hip_command(CLI::App& program, const Screen& screen, std::function<void()>& work);

/// `impinge check`: runs the checker of certificates, a Python program that shares no code with this one.
void add_check_command(CLI::App& program, const Screen& screen, std::function<void()>& work);

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
