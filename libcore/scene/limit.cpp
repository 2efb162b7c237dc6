// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "experiment/stopwatch.hpp"
#include "joint/clock.hpp"
#include "joint/sphere_fit.hpp"
#include "limits/turn_limit.hpp"

namespace impinge {
namespace {

using nlohmann::json;

constexpr double kErrorOfInput = 0.5;  // mm, of the centre or the surface

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

json limit_json(const Turning& turning, const TurnLimit& limit) {
  json found{{"centre", turning.centre},
             {"state", name(limit.state)},
             {"low_deg", limit.low_deg},
             {"high_deg", limit.high_deg}};
  if (!limit.contact) return found;
  const Vec3 place = turning.axes.transpose() * limit.contact->place + turning.origin;
  found["position"] = {{"x", place.x()}, {"y", place.y()}, {"z", place.z()}};
  found["contact"] = name(limit.contact->kind);
  found["clock"] = turning.dial ? json(clock_text(turning.dial->hours(limit.contact->place))) : json(nullptr);
  const bool known = std::isfinite(limit.deg_per_mm);
  found["deg_per_mm"] = known ? json(limit.deg_per_mm) : json(nullptr);
  found["uncertainty_deg"] = known ? json(kErrorOfInput * limit.deg_per_mm) : json(nullptr);
  return found;
}

std::optional<Vec3> socket_centre(const TriangleMesh& socket) {
  try {
    return fit_ball(socket).centre;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::string sentence(const json& limit) {
  char text[256];
  const std::string state = limit["state"];
  if (state == "free") {
    std::snprintf(text, sizeof text, "none up to %.1f degrees", limit["high_deg"].get<double>());
  } else if (state == "blocked") {
    std::snprintf(text, sizeof text, "reached before it begins");
  } else {
    const json& clock = limit["clock"];
    const json& unsure = limit["uncertainty_deg"];
    std::snprintf(text, sizeof text,
                  "between %.4f and %.4f degrees%s; +-%.1f for 0.5 mm of centre or surface",
                  limit["low_deg"].get<double>(), limit["high_deg"].get<double>(),
                  clock.is_null() ? "" : (" at " + clock.get<std::string>() + " o'clock").c_str(),
                  unsure.is_null() ? INFINITY : unsure.get<double>());
  }
  return text;
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
  json contact = json::array({limit_json(turning, fixed.first_contact(turn, largest))});
  const json cartilage = limit_json(turning, fixed.gap_of(turn, options.cartilage_mm, largest));
  if (const auto centre = socket_centre(socket)) {
    turning.origin = joint.centre + axes.transpose() * *centre;
    turning.centre = "socket";
    contact.push_back(
        limit_json(turning, TurnLimits({ball, relative_to(socket, *centre)}).first_contact(turn, largest)));
  }
  const double took_ms = watch.lap_ms();
  return {{"units", {{"length", "mm"}, {"angle", "deg"}, {"time", "ms"}}},
          {"ball", {{"file", options.ball.string()}}},
          {"socket", {{"file", options.socket.string()}}},
          {"question", "limit"},
          {"motion", options.limit->name},
          {"pose", options.pose},
          {"largest_angle_deg", largest},
          {"contact", contact},
          {"cartilage_mm", options.cartilage_mm},
          {"cartilage", cartilage},
          {"warnings", joint.warnings},
          {"times_ms", {{"answer", took_ms}}}};
}

std::string describe_limits(const json& summary) {
  const std::string motion = summary["motion"];
  std::string text =
      "limit               of " + motion + ", from the pose " + summary["pose"].get<std::string>() + "\n";
  for (const json& limit : summary["contact"])
    text += "bone on bone        " + sentence(limit) + ", about the centre of the " +
            limit["centre"].get<std::string>() + "\n";
  char gap[48];
  std::snprintf(gap, sizeof gap, "gap of %g mm", summary["cartilage_mm"].get<double>());
  std::string label(gap);
  label.resize(std::max(label.size() + 1, std::size_t{20}), ' ');
  return text + label + sentence(summary["cartilage"]) + "\n";
}

}  // namespace impinge
