// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of --out, and the files written there.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "command/question_command.hpp"

namespace impinge {

/// The folder of an answer. It is made if missing, and removed again if it stays empty.
class AnswerFolder {
 public:
  /// Throws FileError if no file can be written there.
  explicit AnswerFolder(std::filesystem::path folder);
  AnswerFolder(const AnswerFolder&) = delete;
  AnswerFolder& operator=(const AnswerFolder&) = delete;
  ~AnswerFolder();

  /// Writes the files and summary.json, which lists them; either all are written or none. Returns the files
  /// of an earlier answer that are still there. Throws std::runtime_error if a file would replace an input.
  std::vector<std::string> write(const Told& told, Json& document, const Work& work);

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path there_;  // the nearest folder that existed before
};

}  // namespace impinge
