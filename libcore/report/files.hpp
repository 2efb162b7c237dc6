// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a report.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "joint/report.hpp"
#include "report/answer_document.hpp"

namespace impinge {

/// All files but summary.json: report.html with its plots as SVG and its numbers as CSV. `inputs` are the
/// files that warnings may name, ball and socket first.
std::vector<AnswerFile> report_files(const SessionJoint& joint, const ReportRequest& request,
                                     const ReportAnswer& found,
                                     std::span<const std::filesystem::path> inputs);

}  // namespace impinge
