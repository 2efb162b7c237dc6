// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/asked.hpp"

#include "command/answer_key.hpp"
#include "files/file_bytes.hpp"
#include "files/formatted.hpp"
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

// Degrees; null where no landmarks give a frame.
json landmarks_json(const SceneOptions& options, const Joint& joint) {
  if (!joint.frames) return nullptr;
  const auto& scanned = joint.frames->scanned;
  json found{{"file", options.landmarks ? options.landmarks->string() : ""},
             {"pelvic_tilt_deg", joint.frames->pelvic_tilt_deg},
             {"scanned_flexion_deg", scanned ? json(scanned->flexion) : json(nullptr)},
             {"scanned_abduction_deg", scanned ? json(scanned->abduction) : json(nullptr)},
             {"scanned_internal_rotation_deg", scanned ? json(scanned->internal_rotation) : json(nullptr)}};
  return found;
}

json names_of(const std::vector<std::filesystem::path>& files) {
  json names = json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.string());
  return names;
}

const char* question_name(const SceneOptions& options) {
  if (options.limit != nullptr) return "limit";
  if (options.change) return options.change->of_socket ? "orientation" : "resection";
  if (options.measures) return "measures";
  if (options.volume) return "volume";
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
             {"axes", joint.axes},
             {"landmarks", landmarks_json(options, joint)},
             {"question", question_name(options)},
             {"warnings", joint.warnings}};
  add_taken(joint.ball, asked["ball"]);
  add_taken(joint.socket, asked["socket"]);
  if (!options.ball_parts.empty()) asked["ball"]["parts"] = names_of(options.ball_parts);
  if (!options.socket_parts.empty()) asked["socket"]["parts"] = names_of(options.socket_parts);
  if (options.keep_largest) asked["keep"] = "largest";
  if (options.overlap_mm > 0.0) asked["overlap_mm"] = options.overlap_mm;
  if (options.many()) {
    asked["pose"] = nullptr;
    if (options.poses) asked["poses"] = options.poses->string();
    if (options.path) asked["path"] = *options.path;
    asked["cartilage_mm"] = options.areas ? json(options.cartilage_mm) : json(nullptr);
  } else if (options.limit != nullptr) {
    asked["motion"] = options.motion_asked.empty() ? std::string(options.limit->name) : options.motion_asked;
  } else if (options.change) {
    asked["require"] = options.change->text;
  } else if (options.volume) {
    asked["width"] = options.volume->width;
    asked["gap_mm"] = options.volume->gap_mm;
    asked["centre_within_mm"] = options.volume->centre_within_mm;
  } else {
    asked["surfaces"] = surfaces_name(options);
    asked["scheme"] = options.by_tables() ? json(options.scheme) : json(nullptr);
    asked["precision_deg"] = options.precision_deg ? json(*options.precision_deg) : json(nullptr);
    asked["max_error_mm"] = options.max_error_mm ? json(*options.max_error_mm) : json(nullptr);
  }
  return asked;
}

void add_taken(const JointPart& part, json& found) {
  const auto& taken = part.taken;
  if (taken) found["taken"] = {{"faces", taken->faces}, {"of", taken->of}, {"within_mm", taken->within_mm}};
}

void add_part_names(const Joint& joint, const std::string& ball, const std::string& socket, json& found) {
  const auto named = [](const std::string& name) { return name.empty() ? json(nullptr) : json(name); };
  if (!joint.ball.parts.empty()) found["ball_part"] = named(ball);
  if (!joint.socket.parts.empty()) found["socket_part"] = named(socket);
}

std::string asked_key(const SceneOptions& options, const Joint& joint, std::string_view more) {
  std::uint64_t key = kFnvStart;
  const auto add = [&key](std::string_view bytes) { key = fnv1a(bytes, key); };
  add(read_bytes(options.ball));
  add(read_bytes(options.socket));
  for (const auto* parts : {&options.ball_parts, &options.socket_parts}) {
    for (const std::filesystem::path& part : *parts) add(read_bytes(part));
  }
  if (options.landmarks) add(read_bytes(*options.landmarks));
  add(asked_json(options, joint).dump(-1, ' ', false, json::error_handler_t::replace));
  add(more);
  return formatted("%016llx", static_cast<unsigned long long>(key));
}

}  // namespace impinge
