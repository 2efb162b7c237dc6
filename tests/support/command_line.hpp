// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines of `impinge`, with spaces between the words; '' is an empty one.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/program.hpp"
#include "command/question_command.hpp"

namespace impinge::test {

class CommandLine {
 public:
  explicit CommandLine(const std::string& line) {
    std::istringstream words(line);
    for (std::string word; words >> word;) words_.push_back(word == "''" ? "" : word);
    for (const std::string& word : words_) argv_.push_back(word.c_str());
  }
  int argc() const { return static_cast<int>(argv_.size()); }
  const char* const* argv() const { return argv_.data(); }

 private:
  std::vector<std::string> words_{"impinge"};
  std::vector<const char*> argv_;
};

struct Ran {
  int code;
  std::string out;
  std::string log;
};
inline Ran run(const std::string& line) {
  const CommandLine given(line);
  std::ostringstream out;
  std::ostringstream log;
  const int code = run_program(given.argc(), given.argv(), out, log);
  return {code, out.str(), log.str()};
}

// Of a command that succeeds.
inline Json document_of(const std::string& line) {
  const Ran ran = run(line + " --json");
  if (ran.code != 0) throw std::runtime_error(ran.log);
  return Json::parse(ran.out);
}

// The question with these options of its own.
inline QuestionCommand asked(QuestionCommand question, const std::string& options) {
  CLI::App app;
  question.add_options(app);
  app.parse(options);
  question.check();
  return question;
}

}  // namespace impinge::test
