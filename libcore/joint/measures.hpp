// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a joint, each beside published values of a population.
#pragma once

#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "hip/measure_list.hpp"
#include "hip/published_measures.hpp"
#include "joint/session.hpp"

namespace impinge {

struct MeasureRequest {
  static constexpr std::tuple<> fields{};
};

inline std::optional<std::string_view> text_or_none(std::string_view text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// A measure (hip/measure_list.hpp) and its published values (hip/published_measures.hpp).
struct MeasureRow : Measure {
  PublishedMeasure published;

  static constexpr std::tuple fields{
      Field{"measure", "", "its name", &MeasureRow::name},
      Field{"value", "", "in `unit`; none where it is refused", &MeasureRow::value},
      Field{"uncertainty", "", "in `unit`: how far it moves when it is measured otherwise",
            &MeasureRow::uncertainty},
      Field{"unit", "", "mm, deg or 1", &MeasureRow::unit},
      Field{"state", "", "measured, or refused and why", &MeasureRow::state},
      Field{"published_mean", "", "in `unit`, of a population; none without a source",
            via(&MeasureRow::published, &PublishedMeasure::mean)},
      Field{"published_sd", "", "in `unit`: standard deviation",
            via(&MeasureRow::published, &PublishedMeasure::sd)},
      Field{"published_median", "", "in `unit`, where the source has one in place of a mean",
            via(&MeasureRow::published, &PublishedMeasure::median)},
      Field{"published_lower_quartile", "", "in `unit`",
            via(&MeasureRow::published, &PublishedMeasure::lower_quartile)},
      Field{"published_upper_quartile", "", "in `unit`",
            via(&MeasureRow::published, &PublishedMeasure::upper_quartile)},
      Field{"published_of", "", "the group, and how it was measured",
            via(&MeasureRow::published, &PublishedMeasure::of, &text_or_none)},
      Field{"published_source", "", "where",
            via(&MeasureRow::published, &PublishedMeasure::source, &text_or_none)}};
};

struct MeasureAnswer {
  std::vector<MeasureRow> measures;

  static constexpr std::tuple fields{Field{"measures", "", "each measure", &MeasureAnswer::measures}};
};

/// The meshes to measure, in the joint frame: the ball with what continues it, the socket's main surface.
BallSocketPair measured_meshes(const SessionJoint& joint);

/// The measures in the joint frame; with landmarks this is the frame of the pelvis, with the femur in neutral
/// position. Throws std::invalid_argument without a side.
MeasureAnswer answer(Session& session, const MeasureRequest& request);

}  // namespace impinge
