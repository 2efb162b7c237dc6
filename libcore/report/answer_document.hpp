// SPDX-License-Identifier: GPL-3.0-or-later
// An answer as it is kept: its document and its files.
#pragma once

#include <string>
#include <string_view>

#include "joint/document.hpp"

namespace impinge {

extern const char* const kVersion;  // of the project
/// Of the sources that it was built from, as git abbreviates it, with "-dirty" where files had changed;
/// "unknown" outside of git.
const char* commit();

/// A file of an answer.
struct AnswerFile {
  std::string name;
  std::string bytes;
};

/// What summary.json holds, but for the names of its `files`. Of the question: its joint (JointDocument),
/// request, answer and times.
Json document_of(std::string_view question, Json joint, Json request, Json answer, Json times_ms);

}  // namespace impinge
