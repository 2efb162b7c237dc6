// SPDX-License-Identifier: GPL-3.0-or-later
// Output of the program `scene` for a question that is answered without all gaps, and on what was left out.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "joint/measurement.hpp"
#include "scene/options.hpp"

namespace impinge {

/// Name, meaning, reason and saved bytes of each omission.
nlohmann::json left_out_json(const std::vector<LeftOut>& left_out);

/// How the answer was found and what was left out, as lines of text; `edge_on`: were edge-on faces left out?
std::string describe_way(const std::string& way, const std::vector<LeftOut>& left_out, bool edge_on = false);

/// Has the joint faces whose plane holds the centre? They are left out of all gaps.
bool edge_on_faces(const Joint& joint);
inline constexpr const char* kEdgeOnLeftOut = "faces whose plane holds the centre: they cover no direction";

/// The text of a summary. Bytes that are not UTF-8, as file names may have, become U+FFFD.
std::string json_text(const nlohmann::json& summary);

/// The contents of summary.json for the question: lengths in mm, times in ms.
nlohmann::json question_summary(const SceneOptions& options, const SessionJoint& joint,
                                const QuestionAnswer& found);

/// The same as text for a terminal.
std::string describe_question(const SceneOptions& options, const Joint& joint, const QuestionAnswer& found);

}  // namespace impinge
