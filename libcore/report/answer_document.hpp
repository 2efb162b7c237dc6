// SPDX-License-Identifier: GPL-3.0-or-later
// The document and the files in which an answer is kept.
#pragma once

#include <string>
#include <string_view>

#include "joint/document.hpp"

namespace impinge {

extern const char* const kVersion;  // version of the project
/// Abbreviated git commit of this build's sources, "-dirty" where files had changed; "unknown" outside git.
const char* commit();

/// A file of an answer.
struct AnswerFile {
  std::string name;
  std::string bytes;
};

/// The contents of summary.json without the names of its `files`: the question's joint (JointDocument),
/// request, answer and times.
Json document_of(std::string_view question, Json joint, Json request, Json answer, Json times_ms);

}  // namespace impinge
