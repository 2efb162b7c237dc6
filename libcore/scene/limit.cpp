// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/limit.hpp"

#include <algorithm>

#include "files/formatted.hpp"
#include "scene/asked.hpp"
#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

json end_or_null(const CentreInterval& found) { return found.limited ? json(found.high_deg) : json(nullptr); }

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

json limit_json(const SessionJoint& joint, const LimitAnswer& answer) {
  const ToldLimit& told = answer.told;
  const TurnLimit& limit = told.limit;
  json found{{"centre", answer.about},
             {"centre_of_rotation", point_json(answer.centre)},
             {"threshold_mm", told.threshold_mm},
             {"state", name(limit.state)},
             {"low_deg", limit.low_deg},
             {"high_deg", limit.high_deg},
             {"centre_low_deg", told.common.low_deg},
             {"centre_high_deg", end_or_null(told.common)},
             {"play_low_deg", told.play.low_deg},
             {"play_high_deg", end_or_null(told.play)},
             {"half_mm_gap_deg", or_null(told.half_mm_gap_deg)},
             {"hangs_on_less_than_half_mm", told.hangs_on_less()},
             {"leaves_ball_mesh_deg", or_null(limit.leaves_mesh_deg)}};
  if (!meets(answer).empty()) {
    found["clock"] = answer.hours ? json(clock_text(*answer.hours)) : json(nullptr);
    found.update(
        {{"ball_part", answer.ball_part}, {"socket_part", answer.socket_part}, {"meets", meets(answer)}});
  }
  if (!limit.contact) return found;
  found["position"] = point_json(joint.axes.transpose() * limit.contact->place + answer.centre);
  found["contact"] = name(limit.contact->kind);
  return found;
}

std::string sentence(const LimitAnswer& answer) {
  const TurnLimit& limit = answer.told.limit;
  const std::string low = rounded_down(limit.low_deg, 1);
  switch (limit.state) {
    case LimitState::free:
      return "none up to " + low + " degrees";
    case LimitState::blocked:
      return "reached before it begins" + (meets(answer).empty() ? "" : ", " + meets(answer));
    case LimitState::limited:
      return "between " + rounded_down(limit.low_deg, 4) + " and " + rounded_up(limit.high_deg, 4) +
             " degrees" + (answer.hours ? " at " + clock_text(*answer.hours) + " o'clock" : "") + ", " +
             meets(answer);
    case LimitState::unknown:
      break;
  }
  if (limit.leaves_mesh_deg && *limit.leaves_mesh_deg <= limit.low_deg)
    return "leaves the ball's mesh at " + low + " degrees, none before; unknown beyond";
  return "none up to " + low + " degrees, where surfaces graze; unknown beyond";
}

// What half a millimetre changes, and more of the ball, each on a line of its own below the limit.
std::string doubts(const ToldLimit& told) {
  const TurnLimit& limit = told.limit;
  if (limit.state == LimitState::blocked) return "";
  const std::string below = "\n                    ";
  std::string text = below + formatted("any centre within %g mm: ", kErrorOfInput) + range_text(told.common) +
                     formatted("; play of the ball up to %g mm: ", kErrorOfInput) + range_text(told.play);
  if (told.half_mm_gap_deg)
    text += below + formatted("the gap falls to %g mm at ", kErrorOfInput) +
            rounded_down(*told.half_mm_gap_deg, 1) + " degrees";
  if (told.hangs_on_less()) text += formatted(": this answer is sensitive to less than %g mm", kErrorOfInput);
  if (limit.state == LimitState::limited && limit.leaves_mesh_deg)  // with more of the ball it stays impinged
    text += below + "the ball's mesh ends under the socket from " + rounded_down(*limit.leaves_mesh_deg, 1) +
            " degrees on: what is missing may come first";
  return text;
}

std::string described(std::string label, const LimitAnswer& answer) {
  label.resize(std::max(label.size() + 1, std::size_t{20}), ' ');
  return label + sentence(answer) + ", about the centre of the " + answer.about + doubts(answer.told) + "\n";
}

}  // namespace

std::string range_text(const CentreInterval& range) {
  const std::string from = rounded_down(range.low_deg, 1);
  if (!range.limited) return range.low_deg > 0.0 ? "none before " + from + " degrees" : "unknown";
  return from + " to " + rounded_up(range.high_deg, 1) + " degrees";
}

LimitRequest limit_request(const SceneOptions& options) {
  return {.start = options.motion,
          .growing = std::string(options.limit->name),
          .cartilage_mm = options.cartilage_mm};
}

json limit_summary(const SceneOptions& options, const SessionJoint& joint, const LimitAnswers& found,
                   double milliseconds) {
  json contact = json::array({limit_json(joint, found.contact)});
  if (found.socket) contact.push_back(limit_json(joint, *found.socket));
  json report = asked_json(options, joint.joint);
  report.update({{"largest_angle_deg", found.largest_deg},
                 {"contact", contact},
                 {"cartilage_mm", options.cartilage_mm},
                 {"cartilage", limit_json(joint, found.cartilage)},
                 {"centre_within_mm", kErrorOfInput},
                 {"times_ms", {{"answer", milliseconds}}}});
  return report;
}

std::string describe_limits(const SceneOptions& options, const LimitAnswers& found) {
  std::string text = "limit               of " + std::string(options.limit->name) + ", from the pose " +
                     options.pose + "\n" + described("bone on bone", found.contact);
  if (found.socket) text += described("bone on bone", *found.socket);
  return text + described(formatted("gap of %g mm", options.cartilage_mm), found.cartilage);
}

}  // namespace impinge
