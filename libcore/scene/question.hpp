// SPDX-License-Identifier: GPL-3.0-or-later
// What the program `scene` says of a question that is answered without all gaps, and of what it left out.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/joint.hpp"
#include "scene/planned_answer.hpp"

namespace impinge {

/// Of each omission its name, meaning, reason and the bytes that it saved.
nlohmann::json left_out_json(const std::vector<LeftOut>& left_out);

/// The same as lines of text.
std::string describe_left_out(const nlohmann::json& left_out);

/// How the answer was found, a line of text of a summary's "way".
std::string describe_way(const nlohmann::json& way);

/// The text of a summary. Names of files may hold any bytes; what is no UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::json& summary);

/// The contents of summary.json for the question: lengths in mm, times in ms.
nlohmann::json question_summary(const SceneOptions& options, const Joint& joint, const QuestionAnswer& found);

/// The same for a reader at a terminal.
std::string describe_question(const nlohmann::json& summary);

}  // namespace impinge
