// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "command/program.hpp"
#include "files/file_error.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

// The checker is beside the installed program, or in the sources of this build.
fs::path checker() {
  std::error_code unreadable;
  const fs::path program = fs::read_symlink("/proc/self/exe", unreadable);
  const fs::path installed = program.parent_path().parent_path() / "share/impinge/check_certificate.py";
  return fs::exists(installed, unreadable) ? installed : fs::path(IMPINGE_CHECKER);
}

// Runs a program and returns its exit code.
int run(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, argv.front(), nullptr, nullptr, argv.data(), environ);
  if (error != 0)
    throw std::runtime_error("python3: cannot be run, " + system_message(error) +
                             "; install it, the checker of certificates is written in Python");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

void add_check_command(CLI::App& program, const Screen& /*screen*/, std::function<void()>& work) {
  struct Files {
    std::string certificate;
    std::string ball;
    std::string socket;
    std::vector<std::string> ball_parts;
    std::vector<std::string> socket_parts;
  };
  const auto files = std::make_shared<Files>();
  CLI::App& app = *program.add_subcommand(
      "check", "Checks a certificate in exact arithmetic, by a program that shares no code with this one.");
  app.footer("Example: impinge check proof/certificate.txt femur.ply pelvis.ply");
  app.add_option("FILE", files->certificate, "the certificate that impinge certify wrote")
      ->type_name("")
      ->required();
  app.add_option("BALL", files->ball, "the mesh of the ball")->type_name("")->required();
  app.add_option("SOCKET", files->socket, "the mesh of the socket")->type_name("")->required();
  app.add_option("--ball-part", files->ball_parts, "each part of the ball's bone that certify was given")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--socket-part", files->socket_parts, "each part of the socket's bone")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.parse_complete_callback([files, &work] {
    work = [files] {
      std::vector<std::string> words{"python3", checker().string(), files->certificate, files->ball,
                                     files->socket};
      const auto add = [&words](const char* option, const std::vector<std::string>& parts) {
        if (parts.empty()) return;
        words.emplace_back(option);
        words.insert(words.end(), parts.begin(), parts.end());
      };
      add("--ball-part", files->ball_parts);
      add("--socket-part", files->socket_parts);
      if (const int code = run(words); code != 0) throw Refused(code);
    };
  });
}

}  // namespace impinge
