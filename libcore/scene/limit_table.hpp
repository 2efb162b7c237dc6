// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of several motions, as rows of limits.csv.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/csv.hpp"
#include "joint/limits.hpp"
#include "scene/options.hpp"

namespace impinge {

/// One of named_motions(), and its limits.
struct MotionLimits {
  std::string motion;
  LimitAnswers found;
};

/// Limits of each named motion that the options ask for: from its own start if all are asked for, else from
/// options.motion.
std::vector<MotionLimits> answer_motions(Session& session, const SceneOptions& options);

/// limits.csv without rows: joint, motion, threshold_mm (0: contact of the surfaces), centre (ball or socket,
/// about whose centre the ball turns), state, low_deg, high_deg (limits/turn_limit.hpp), centre_low_deg,
/// centre_high_deg (for every common centre within 0.5 mm), half_mm_gap_deg, clock, what (what_of()).
Table limit_table();

/// Adds a row for each limit of a joint.
void add_limits(const std::string& joint, const std::vector<MotionLimits>& motions, Table& table);

/// The contents of summary.json: what was asked, and the limits of each motion as in limit_summary().
nlohmann::json limits_summary(const SceneOptions& options, const SessionJoint& joint,
                              const std::vector<MotionLimits>& motions, double milliseconds);

/// A line of text for each motion.
std::string describe_motions(const std::vector<MotionLimits>& motions);

}  // namespace impinge
