// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a joint as one HTML file that loads nothing else.
#pragma once

#include <string>
#include <string_view>

#include "joint/document.hpp"
#include "joint/joint_document.hpp"
#include "joint/report.hpp"

namespace impinge {

/// The parts of a page.
struct ReportParts {
  std::string ball;        // name of the ball's file
  std::string socket;      // name of the socket's file
  std::size_t doubts = 0;  // this many warnings, the first ones, make the joint itself doubtful
  Json joint{};            // the document of JointDocument
  Json request{};          // a ReportRequest
  Json answer{};           // a ReportAnswer
  Json scene{};            // from report_scene()
  // Plots as SVG; empty where there is none.
  std::string clock{};
  std::string limits{};
  std::string volume{};
  std::string measures{};
  std::string program{};      // that makes it, as "impinge 0.4.0, commit 01234567"
  std::string_view viewer{};  // kReportViewer; without it no bones are drawn
};

/// The parts that follow from the answer. The caller adds the viewer and the names of who makes the page.
ReportParts report_parts(const SessionJoint& joint, const JointNames& names, const ReportRequest& request,
                         const ReportAnswer& found);

std::string report_page(const ReportParts& parts);

/// The script that draws the bones (analysis/joint3d/report/viewer.js with what it uses). Empty where it
/// could not be made. Not linked in WebAssembly, where the page has it.
extern const std::string_view kReportViewer;
/// What to do if the script is empty, in one clause.
std::string viewer_missing();

}  // namespace impinge
