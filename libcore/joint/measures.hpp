// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a joint, each beside what is published of a population.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/session.hpp"

namespace impinge {

struct MeasureRequest {
  static constexpr auto fields() { return std::tuple{}; }
};

/// A measure (hip/measure_list.hpp), and what is published of it (hip/published_measures.hpp).
struct MeasureRow {
  std::string measure;
  std::optional<double> value;
  std::optional<double> uncertainty;
  std::string unit;
  std::string state;
  std::optional<double> published_mean;
  std::optional<double> published_sd;
  std::optional<double> published_median;
  std::optional<double> published_lower_quartile;
  std::optional<double> published_upper_quartile;
  std::optional<std::string_view> published_of;
  std::optional<std::string_view> published_source;

  static constexpr auto fields() {
    using Row = MeasureRow;
    return std::tuple{Field{"measure", "", "its name", &Row::measure},
                      Field{"value", "", "in `unit`; none where it is refused", &Row::value},
                      Field{"uncertainty", "", "in `unit`: how far it moves when it is measured otherwise",
                            &Row::uncertainty},
                      Field{"unit", "", "mm, deg or 1", &Row::unit},
                      Field{"state", "", "measured, or refused and why", &Row::state},
                      Field{"published_mean", "", "in `unit`, of a population; none without a source",
                            &Row::published_mean},
                      Field{"published_sd", "", "in `unit`: standard deviation", &Row::published_sd},
                      Field{"published_median", "", "in `unit`, where the source has one in place of a mean",
                            &Row::published_median},
                      Field{"published_lower_quartile", "", "in `unit`", &Row::published_lower_quartile},
                      Field{"published_upper_quartile", "", "in `unit`", &Row::published_upper_quartile},
                      Field{"published_of", "", "the group, and how it was measured", &Row::published_of},
                      Field{"published_source", "", "where", &Row::published_source}};
  }
};

struct MeasureAnswer {
  std::vector<MeasureRow> measures;

  static constexpr auto fields() {
    return std::tuple{Field{"measures", "", "each measure", &MeasureAnswer::measures}};
  }
};

/// The measures in the joint frame. With landmarks this is the frame of the pelvis, the femur in neutral
/// position. std::invalid_argument without a side.
MeasureAnswer answer(Session& session, const MeasureRequest& request);
std::vector<MeasureRow> answer_measures(const SessionJoint& joint);

}  // namespace impinge
