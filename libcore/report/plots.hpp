// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a report, each as SVG. They show the documents of its questions (joint/report.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "joint/document.hpp"
#include "report/clock.hpp"

namespace impinge {

/// The gaps of the socket on the unrolled clock, the smallest gap of each hour, and where each level is
/// reached. `gaps` is the document of a GapsAnswer.
std::string clock_plot(const ClockMap& map, const Json& gaps);

/// How far each motion goes: a bar to its limit, its range over the error of the centre, and what meets.
/// `limits` is the document of a LimitsAnswer.
std::string limits_plot(const Json& limits);

/// Each measure with published values, in standard deviations from their mean; empty if there is none.
/// `measures` is the document of a MeasureAnswer.
std::string measures_plot(const Json& measures);

/// Turns the name of a motion into "internal rotation, at 90 degrees of flexion".
std::string motion_words(const std::string& name);

/// Turns "alpha_at_1_30" into "alpha angle at 1:30".
std::string measure_words(const std::string& name);

/// Limits about the ball's centre, one for each motion: of contact, or with `cartilage` of its thickness.
std::vector<Json> ball_limits(const Json& limits, bool cartilage);

/// Distance of a measure from its published mean or median, in standard deviations; quartiles are taken as
/// those of a normal distribution. None if there is no measure or no published value.
std::optional<double> published_distance(const Json& measure);

/// How far a motion goes, in degrees: "103.8", "over 180", "0, blocked".
std::string reach_words(const Json& limit);

}  // namespace impinge
