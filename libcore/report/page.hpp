// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a joint as one HTML file that asks for nothing beyond itself.
#pragma once

#include <string>
#include <string_view>

#include "joint/document.hpp"
#include "joint/joint_document.hpp"
#include "joint/report.hpp"

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
  std::string program{};      // that makes it, as "impinge 0.3.0, commit 01234567"
  std::string_view viewer{};  // kReportViewer; without it no bones are drawn
};

/// Of an answer about the joint: all but who makes the page, and with what.
ReportParts report_parts(const SessionJoint& joint, const JointNames& names, const ReportRequest& request,
                         const ReportAnswer& found);

std::string report_page(const ReportParts& parts);

/// The script that draws the bones (analysis/joint3d/report/viewer.js with what it uses). Empty where it
/// could not be made; not there at all in WebAssembly, where the page has it.
extern const std::string_view kReportViewer;
/// What to do where it is empty, one clause.
std::string viewer_missing();

}  // namespace impinge
