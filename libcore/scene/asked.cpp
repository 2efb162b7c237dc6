// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/asked.hpp"

#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

json centre_json(const Joint& joint) {
  json centre = point_json(joint.centre);
  centre["source"] = joint.fit ? "fitted" : "given";
  centre["radius_mm"] = joint.fit ? json(joint.fit->radius) : json(nullptr);
  centre["residual_rms_mm"] = joint.fit ? json(joint.fit->rms) : json(nullptr);
  centre["vertices_used"] = joint.fit ? json(joint.fit->points) : json(nullptr);
  return centre;
}

const char* question_name(const SceneOptions& options) {
  if (options.limit != nullptr) return "limit";
  if (options.question == Question::touch) return "touch";
  return options.question == Question::first_contact ? "first-contact" : "all-gaps";
}

const char* surfaces_name(const SceneOptions& options) {
  if (options.scan_ball && options.scan_socket) return "both";
  return options.scan_ball ? "ball" : "socket";
}

}  // namespace

json asked_json(const SceneOptions& options, const Joint& joint) {
  json asked{{"units", {{"length", "mm"}, {"area", "mm^2"}, {"angle", "deg"}, {"time", "ms"}}},
             {"ball", {{"file", options.ball.string()}}},
             {"socket", {{"file", options.socket.string()}}},
             {"centre", centre_json(joint)},
             {"pose", options.pose},
             {"side", options.side ? json(*options.side == Side::left ? "left" : "right") : json(nullptr)},
             {"axes", options.axes},
             {"question", question_name(options)},
             {"warnings", joint.warnings}};
  if (options.many()) {
    asked["pose"] = nullptr;
    if (options.poses) asked["poses"] = options.poses->string();
    if (options.path) asked["path"] = *options.path;
  } else if (options.limit != nullptr) {
    asked["motion"] = options.limit->name;
  } else {
    asked["surfaces"] = surfaces_name(options);
    asked["scheme"] = options.by_tables() ? json(options.scheme) : json(nullptr);
    asked["precision_deg"] = options.precision_deg ? json(*options.precision_deg) : json(nullptr);
    asked["max_error_mm"] = options.max_error_mm ? json(*options.max_error_mm) : json(nullptr);
  }
  return asked;
}

}  // namespace impinge
