// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/program.hpp"

#include <algorithm>
#include <exception>
#include <new>
#include <thread>

#include "command/hip.hpp"
#include "command/joint_command.hpp"
#include "command/version.hpp"
#include "files/one_line.hpp"
#include "joint/document.hpp"

namespace impinge {
namespace {

constexpr const char* kAbout =
    "How far a ball-and-socket joint turns before its bones meet, and where: range of motion, "
    "femoroacetabular\n"
    "impingement, joint space, resection. BALL and SOCKET are meshes in mm, such as a femur and a pelvis.";
constexpr const char* kFooter =
    "Exit code: 0; 1 where a mesh or file cannot be used; 2 for a wrong command or option.";

// The first word that is no option.
std::string command_word(int argc, const char* const* argv) {
  for (int k = 1; k < argc; ++k)
    if (argv[k][0] != '-') return argv[k];
  return "";
}

void require_command(const std::string& word, const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  std::vector<std::string_view> words(names.begin(), names.end());
  if (!word.empty()) place_among(word, words, "impinge");
}

// What CLI11 says of a wrong option, and the near one.
std::string advice(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* command = &program;
  for (const CLI::App* asked : program.get_subcommands()) command = asked;
  std::string text = error.what();
  std::vector<std::string> names;
  for (const CLI::Option* option : command->get_options()) names.push_back(option->get_name());
  const std::vector<std::string_view> words(names.begin(), names.end());
  for (const std::string& extra : program.remaining(true)) {
    const std::string_view near = near_word(extra.substr(0, extra.find('=')), words);
    if (!near.empty()) text += "; did you mean " + std::string(near) + "?";
  }
  return text + "; see " + (command == &program ? "impinge" : "impinge " + command->get_name()) + " --help";
}

// An empty text is what a script gives whose variable is not set.
void refuse_empty_values(CLI::App& program) {
  const CLI::Validator given(
      [](const std::string& text) {
        return std::string(text.empty() ? "is empty; give it a value or leave it out" : "");
      },
      "");
  for (CLI::App* command : program.get_subcommands({}))
    for (CLI::Option* option : command->get_options()) option->transform(given);  // before all other checks
}

}  // namespace

std::function<void()> parse_program(int argc, const char* const* argv, const Screen& screen,
                                    std::span<const AddCommand> more) {
  CLI::App program{kAbout, "impinge"};
  program.footer(kFooter);
  program.require_subcommand(0, 1);
  program.set_version_flag("--version", std::string("impinge ") + kVersion + " (commit " + commit() + ")");
  std::function<void()> work;  // of the command that was given
  add_joint_commands(program, screen, work);
  add_check_command(program, screen, work);
  add_hip_command(program, screen, work);
  for (const AddCommand add : more) add(program, screen, work);
  refuse_empty_values(program);
  try {
    require_command(command_word(argc, argv), program);
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    program.exit(asked, screen.out, screen.log);
    return [] {};
  } catch (const CLI::ParseError& error) {
    throw CommandError(one_line(advice(program, error)));
  } catch (const std::exception& error) {
    throw CommandError(one_line(error.what()));
  }
  if (!work) screen.out << program.help();
  return work;
}

int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& log,
                std::span<const AddCommand> more) {
  const auto fail = [&log](const std::string& what, int code) {
    log << "impinge: error: " << one_line(what) << std::endl;
    return code;
  };
  const Screen screen{out, log};
  try {
    const std::function<void()> work = parse_program(argc, argv, screen, more);
    if (!work) return 2;
    work();
  } catch (const Refused& refused) {
    return refused.code;
  } catch (const CommandError& error) {
    return fail(error.what(), 2);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory; choose a coarser --precision or smaller meshes", 1);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
  return 0;
}

}  // namespace impinge
