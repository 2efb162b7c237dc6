// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of several motions, as rows of limits.csv.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/csv.hpp"
#include "scene/options.hpp"
#include "session/limits.hpp"

namespace impinge {

/// One of named_motions(), and its limits.
struct MotionLimits {
  std::string motion;
  LimitAnswers found;
};

/// Of each motion that the options ask for, from its own start.
std::vector<MotionLimits> answer_motions(Session& session, const SceneOptions& options);

/// limits.csv without rows: joint, motion, threshold_mm (0: contact of the surfaces), centre (about whose the
/// ball turns), state, low_deg, high_deg (motion/turn_limit.hpp), centre_low_deg, centre_high_deg (for every
/// common centre within 0.5 mm), half_mm_gap_deg, clock, and what a reader must know of it in words.
Table limit_table();

/// Adds a row for each limit of a joint.
void add_limits(const std::string& joint, const std::vector<MotionLimits>& motions, Table& table);

/// The contents of summary.json: what was asked, and of each motion what limit_summary() has.
nlohmann::json limits_summary(const SceneOptions& options, const SessionJoint& joint,
                              const std::vector<MotionLimits>& motions, double milliseconds);

/// A line for each motion, for a reader at a terminal.
std::string describe_motions(const std::vector<MotionLimits>& motions);

}  // namespace impinge
