// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/program.hpp"

#include <algorithm>
#include <memory>
#include <new>

#include "command/request_options.hpp"
#include "files/one_line.hpp"
#include "joint/document.hpp"
#include "report/answer_document.hpp"

namespace impinge {
namespace {

constexpr const char* kAbout =
    "How far a ball-and-socket joint turns before its bones meet, and where: range of motion, "
    "femoroacetabular\n"
    "impingement, joint space, resection. BALL and SOCKET are meshes in mm, such as a femur and a pelvis.";
constexpr const char* kFooter =
    "Exit code: 0; 1 where a mesh or file cannot be used; 2 for a wrong command or option.";

void require_command(const std::string& word, const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  std::vector<std::string_view> words(names.begin(), names.end());
  place_among(word, words, "impinge");
}

// The command that is given, or the program itself.
const CLI::App& asked(const CLI::App& program) {
  const auto given = program.get_subcommands();
  return given.empty() ? program : *given.back();
}

// "impinge" or "impinge gaps".
std::string full_name(const CLI::App& command) {
  return (command.get_parent() ? "impinge " : "") + command.get_name();
}

// What is wrong with the words left over, and what may be meant. Options come before other words.
std::string unexpected(const CLI::App& program) {
  const std::vector<std::string> extras = program.remaining(true);
  const auto option = std::find_if(extras.begin(), extras.end(), [](const auto& x) { return x[0] == '-'; });
  if (option == extras.end()) return "'" + extras.front() + "' was not expected";
  const CLI::App& command = asked(program);
  const std::string name = option->substr(0, option->find('='));
  if (command.get_option_no_throw(name) != nullptr) return name + ": give it behind " + full_name(command);
  std::vector<std::string> names;
  for (const CLI::Option* one : command.get_options()) names.push_back(one->get_name());
  const std::string_view near = near_word(name, std::vector<std::string_view>(names.begin(), names.end()));
  const std::string text = name + ": is no option of " + full_name(command);
  if (!near.empty()) return text + "; did you mean " + std::string(near) + "?";
  std::string others;
  for (const CLI::App* other : program.get_subcommands({}))
    if (other->get_option_no_throw(name) != nullptr)
      others += (others.empty() ? ", but of " : " and ") + full_name(*other);
  return text + others;
}

// The error of a command line. "clearance_mm: " of a request becomes "--clearance: " here.
std::string advice(const CLI::App& program, std::string what) {
  const CLI::App& command = asked(program);
  const std::string field = what.substr(0, what.find(':'));
  const std::string option = option_name(field);
  if (command.get_option_no_throw(option) != nullptr) what.replace(0, field.size(), option);
  return one_line(what + (what.back() == '?' ? " See " : "; see ") + full_name(command) + " --help");
}

// Scripts give an empty text where a variable is not set.
void refuse_empty_values(CLI::App& program) {
  const CLI::Validator given(
      [](const std::string& text) {
        return std::string(text.empty() ? "is empty; give it a value or leave it out" : "");
      },
      "");
  for (CLI::App* command : program.get_subcommands({}))
    for (CLI::Option* option : command->get_options()) option->transform(given);  // before all other checks
}

// CLI11 lists at each option all that it excludes. This is longer than the option, whose text says it anyway.
class Help : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string all = CLI::Formatter::make_option_opts(option);
    return all.substr(0, all.find(" Excludes:"));
  }
};

}  // namespace

std::function<void()> parse_program(int argc, const char* const* argv, const Screen& screen,
                                    std::span<const AddCommand> more) {
  const auto kept = std::make_shared<CLI::App>(kAbout, "impinge");
  CLI::App& program = *kept;
  program.formatter(std::make_shared<Help>());
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
    if (argc > 1 && argv[1][0] != '-') require_command(argv[1], program);
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    program.exit(asked, screen.out, screen.log);
    return [] {};
  } catch (const CLI::ExtrasError&) {
    throw CommandError(advice(program, unexpected(program)));
  } catch (const CLI::ParseError& error) {
    throw CommandError(advice(program, error.what()));
  } catch (const std::invalid_argument& error) {
    throw CommandError(advice(program, error.what()));
  }
  if (!work) {
    screen.out << program.help();
    return work;
  }
  return [kept, work] {
    try {
      work();
    } catch (const std::invalid_argument& error) {
      throw CommandError(advice(*kept, error.what()));
    }
  };
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
    if (!out.flush()) return fail("the answer could not be printed; check that its destination has room", 1);
  } catch (const Refused& refused) {
    return refused.code;
  } catch (const CommandError& error) {
    return fail(error.what(), 2);
  } catch (const std::bad_alloc&) {
    log << "impinge: error: " << kNoMemory << std::endl;  // needs no more memory
    return 1;
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
  return 0;
}

}  // namespace impinge
