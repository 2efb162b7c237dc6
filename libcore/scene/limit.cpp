// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/limit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/stopwatch.hpp"
#include "gap/formatted.hpp"
#include "hip/clock.hpp"
#include "hip/sphere_fit.hpp"
#include "motion/told_limit.hpp"
#include "scene/asked.hpp"
#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

TriangleMesh rotated(TriangleMesh mesh, const Eigen::Matrix3d& rotation) {
  for (Vec3& x : mesh.vertices) x = rotation * x;
  return mesh;
}

// A joint in the joint frame that turns about its origin, and where that is in the input frame.
struct Turning {
  Eigen::Matrix3d axes;
  std::optional<ClockFace> dial;
  Vec3 origin;
  const char* centre;
};

json end_or_null(const CentreInterval& found) { return found.limited ? json(found.high_deg) : json(nullptr); }

json limit_json(const Turning& turning, const ToldLimit& told) {
  const TurnLimit& limit = told.limit;
  json found{{"centre", turning.centre},
             {"centre_of_rotation", point_json(turning.origin)},
             {"threshold_mm", told.threshold_mm},
             {"state", name(limit.state)},
             {"low_deg", limit.low_deg},
             {"high_deg", limit.high_deg},
             {"centre_low_deg", told.common.low_deg},
             {"centre_high_deg", end_or_null(told.common)},
             {"play_low_deg", told.play.low_deg},
             {"play_high_deg", end_or_null(told.play)},
             {"half_mm_gap_deg", told.half_mm_gap_deg ? json(*told.half_mm_gap_deg) : json(nullptr)},
             {"hangs_on_less_than_half_mm", told.hangs_on_less()},
             {"leaves_ball_mesh_deg", limit.leaves_mesh_deg ? json(*limit.leaves_mesh_deg) : json(nullptr)}};
  if (!limit.contact) return found;
  found["position"] = point_json(turning.axes.transpose() * limit.contact->place + turning.origin);
  found["contact"] = name(limit.contact->kind);
  found["clock"] = turning.dial ? json(clock_text(turning.dial->hours(limit.contact->place))) : json(nullptr);
  return found;
}

std::optional<Vec3> socket_centre(const TriangleMesh& socket) {
  try {
    return fit_ball(socket).centre;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::string at_clock(const json& limit) {
  if (!limit.contains("clock") || limit["clock"].is_null()) return "";
  return " at " + limit["clock"].get<std::string>() + " o'clock";
}

std::string sentence(const json& limit) {
  const std::string state = limit["state"];
  const std::string low = rounded_down(limit["low_deg"], 1);
  const json& leaves = limit["leaves_ball_mesh_deg"];
  if (state == "free") return "none up to " + low + " degrees";
  if (state == "blocked") return "reached before it begins";
  if (state == "limited")
    return "between " + rounded_down(limit["low_deg"], 4) + " and " + rounded_up(limit["high_deg"], 4) +
           " degrees" + at_clock(limit);
  if (!leaves.is_null() && leaves <= limit["low_deg"])
    return "leaves the ball's mesh at " + low + " degrees, none before; unknown beyond";
  return "none up to " + low + " degrees, where surfaces graze; unknown beyond";
}

std::string range_text(const json& low, const json& high) {
  const std::string from = rounded_down(low, 1);
  if (high.is_null()) return low > 0.0 ? "none before " + from + " degrees" : "unknown";
  return from + " to " + rounded_up(high, 1) + " degrees";
}

// What half a millimetre changes, and more of the ball, each on a line of its own below the limit.
std::string doubts(const json& limit) {
  if (limit["state"] == "blocked") return "";
  const std::string below = "\n                    ";
  std::string text = below + formatted("any centre within %g mm: ", kErrorOfInput) +
                     range_text(limit["centre_low_deg"], limit["centre_high_deg"]) +
                     formatted("; play of the ball up to %g mm: ", kErrorOfInput) +
                     range_text(limit["play_low_deg"], limit["play_high_deg"]);
  if (!limit["half_mm_gap_deg"].is_null())
    text += below + formatted("the gap falls to %g mm at ", kErrorOfInput) +
            rounded_down(limit["half_mm_gap_deg"], 1) + " degrees";
  if (limit["hangs_on_less_than_half_mm"].get<bool>())
    text += formatted(": this answer hangs on less than %g mm", kErrorOfInput);
  const json& leaves = limit["leaves_ball_mesh_deg"];
  if (limit["state"] == "limited" && !leaves.is_null())  // with more of the ball an impinged pose stays one
    text += below + "the ball's mesh ends under the socket from " + rounded_down(leaves, 1) +
            " degrees on: what is missing may come first";
  return text;
}

std::string described(std::string label, const json& limit) {
  label.resize(std::max(label.size() + 1, std::size_t{20}), ' ');
  return label + sentence(limit) + ", about the centre of the " + limit["centre"].get<std::string>() +
         doubts(limit) + "\n";
}

}  // namespace

json limit_summary(const SceneOptions& options, const Joint& joint) {
  Stopwatch watch;
  const Eigen::Matrix3d axes = input_to_joint(options.axes);
  const TriangleMesh ball = rotated(joint.ball.mesh, axes);
  const TriangleMesh socket = rotated(joint.socket.mesh, axes);
  const JointTurn turn = joint_turn(options.motion, *options.limit, options.side);
  const double largest = largest_growth(options.motion, *options.limit);
  Turning turning{axes, clock_face(socket), joint.centre, "ball"};
  const TurnLimits fixed({ball, socket});
  json contact = json::array({limit_json(turning, told_limit(fixed, turn, 0.0, largest))});
  const json cartilage = limit_json(turning, told_limit(fixed, turn, options.cartilage_mm, largest));
  if (const auto centre = socket_centre(socket)) {
    turning.origin = joint.centre + axes.transpose() * *centre;
    turning.centre = "socket";
    const TurnLimits about_socket({ball, relative_to(socket, *centre)});
    contact.push_back(limit_json(turning, told_limit(about_socket, turn, 0.0, largest)));
  }
  json report = asked_json(options, joint);
  report.update({{"largest_angle_deg", largest},
                 {"contact", contact},
                 {"cartilage_mm", options.cartilage_mm},
                 {"cartilage", cartilage},
                 {"centre_within_mm", kErrorOfInput},
                 {"times_ms", {{"answer", watch.lap_ms()}}}});
  return report;
}

std::string describe_limits(const json& summary) {
  const std::string motion = summary["motion"];
  std::string text =
      "limit               of " + motion + ", from the pose " + summary["pose"].get<std::string>() + "\n";
  for (const json& limit : summary["contact"]) text += described("bone on bone", limit);
  return text +
         described(formatted("gap of %g mm", summary["cartilage_mm"].get<double>()), summary["cartilage"]);
}

}  // namespace impinge
