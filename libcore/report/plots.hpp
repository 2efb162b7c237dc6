// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a report, SVG each. What they show are the documents of its questions (joint/report.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "joint/document.hpp"
#include "report/clock.hpp"

namespace impinge {

/// The gaps of the socket on the unrolled clock, the smallest of each hour, and where the levels are reached.
/// `gaps`: the document of GapsAnswer.
std::string clock_plot(const ClockMap& map, const Json& gaps);

/// How far each motion goes: a bar to its limit, its range over the centre, and what meets what. `limits`:
/// the document of LimitsAnswer.
std::string limits_plot(const Json& limits);

/// Each measure that has published values, in standard deviations from their mean. Empty where none has.
/// `measures`: the document of MeasureAnswer.
std::string measures_plot(const Json& measures);

/// "internal rotation, at 90 degrees of flexion" of the motion's name.
std::string motion_words(const std::string& name);

/// "alpha angle at 1:30" of "alpha_at_1_30".
std::string measure_words(const std::string& name);

/// Limits of contact about the ball's centre, one a motion; with `cartilage` those of its thickness.
std::vector<Json> ball_limits(const Json& limits, bool cartilage);

/// How far a measure is from what is published, in standard deviations; of a median, in those that its
/// quartiles have of a normal distribution. None where either is missing.
std::optional<double> published_distance(const Json& measure);

/// "103.8", "over 180", "0, blocked": how far it goes, in degrees.
std::string reach_words(const Json& limit);

}  // namespace impinge
