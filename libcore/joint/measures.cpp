// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/measures.hpp"

#include <stdexcept>
#include <tuple>

#include "hip/measure_list.hpp"
#include "hip/published_measures.hpp"

namespace impinge {
namespace {

std::optional<std::string_view> text_or_none(std::string_view text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

MeasureRow row_of(const Measure& measure) {
  const PublishedMeasure published = published_measure(measure.name);
  return {measure.name,
          measure.value,
          measure.uncertainty,
          measure.unit,
          measure.state,
          published.mean,
          published.sd,
          published.median,
          published.lower_quartile,
          published.upper_quartile,
          text_or_none(published.of),
          text_or_none(published.source)};
}

}  // namespace

MeasureAnswer answer(Session& session, const MeasureRequest& /*request*/) {
  return {answer_measures(*session.joint)};
}

std::vector<MeasureRow> answer_measures(const SessionJoint& joint) {
  if (!joint.side) throw std::invalid_argument("side: measures need to know it; give left or right");
  const auto& [ball, socket] = std::tie(joint.joint.ball, joint.joint.socket);
  std::vector<MeasureRow> rows;
  for (const Measure& measure : measure_hip({in_joint_frame(joint, whole_main(ball.mesh, ball.parts)),
                                             in_joint_frame(joint, main_surface(socket.mesh, socket.parts))},
                                            *joint.side))
    rows.push_back(row_of(measure));
  return rows;
}

}  // namespace impinge
