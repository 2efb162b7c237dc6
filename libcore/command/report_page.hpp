// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a joint as one HTML file that asks for nothing beyond itself.
#pragma once

#include <string>

#include "joint/document.hpp"

namespace impinge {

/// What a page is made of.
struct ReportParts {
  std::string ball;        // name of its file
  std::string socket;      // the same
  std::size_t doubts = 0;  // how many warnings, the first, make the joint itself doubtful
  Json joint{};            // the document of JointDocument
  Json request{};          // of ReportRequest
  Json answer{};           // of ReportAnswer
  Json scene{};            // of report_scene()
  // SVG each; empty where there is none.
  std::string clock{};
  std::string limits{};
  std::string volume{};
  std::string measures{};
};

std::string report_page(const ReportParts& parts);

/// Whether this program holds the viewer that draws the bones.
bool has_viewer();
/// What to do where it does not, one clause.
std::string viewer_missing();

}  // namespace impinge
