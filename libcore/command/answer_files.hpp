// SPDX-License-Identifier: GPL-3.0-or-later
// The folder that --out names, and what is written there.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "command/question_command.hpp"

namespace impinge {

/// The folder of an answer. Made when it is missing, and taken away again where it stays empty.
class AnswerFolder {
 public:
  /// FileError if no file can be written there.
  explicit AnswerFolder(std::filesystem::path folder);
  AnswerFolder(const AnswerFolder&) = delete;
  AnswerFolder& operator=(const AnswerFolder&) = delete;
  ~AnswerFolder();

  /// Writes the files together with summary.json, which lists them, all or none. std::runtime_error if one of
  /// them would replace an input. Returns files of an earlier answer that are still there.
  std::vector<std::string> write(const Told& told, Json& document, const Work& work);

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path there_;  // the nearest folder that there was
};

}  // namespace impinge
