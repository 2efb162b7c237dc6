// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "mesh/raw_mesh.hpp"

namespace impinge {
namespace {

constexpr double kFinest = 0.2;  // degrees: 1.2 million entries and more a table

NamedMesh mesh_request(const val& value) {
  const auto name = value["name"].as<std::string>();
  const auto positions = emscripten::convertJSArrayToNumberVector<double>(value["positions"]);
  std::vector<std::uint32_t> corners;
  if (is_given(value["faces"]))
    corners = emscripten::convertJSArrayToNumberVector<std::uint32_t>(value["faces"]);
  return {name, mesh_of(name, {positions, corners})};
}

// A mesh and the parts beside it, each called as its file is.
NamedMesh bone_request(const val& value) {
  NamedMesh bone = mesh_request(value);
  if (!is_given(value["parts"])) return bone;
  for (const val& part : emscripten::vecFromJSArray<val>(value["parts"])) {
    const NamedMesh read = mesh_request(part);
    append_part(bone.mesh, bone.parts, read.name.substr(0, read.name.rfind('.')), read.mesh);
    bone.part_names.push_back(read.name);
  }
  return bone;
}

// Of a mesh whose file's first bytes came with it.
SaidAxes said_axes(const val& mesh) {
  SaidAxes said{mesh["name"].as<std::string>(), std::nullopt};
  if (!is_given(mesh["head"])) return said;
  const auto bytes = emscripten::convertJSArrayToNumberVector<std::uint8_t>(mesh["head"]);
  said.code = declared_axes(said.file, std::string(bytes.begin(), bytes.end()));
  return said;
}

Vec3 vector_request(const val& value) {
  const auto x = emscripten::convertJSArrayToNumberVector<double>(value);
  if (x.size() != 3 || !std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); }))
    throw std::invalid_argument("a point is three numbers: x, y and z in mm");
  return {x[0], x[1], x[2]};
}

double angle_of(const val& value, const char* name) {
  const double angle = number_of(value, name, 0.0);
  if (std::abs(angle) <= kLargestAngle) return angle;
  throw std::invalid_argument(std::string(name) + " is no angle of a joint; give degrees from -180 to 180");
}

double cartilage_of(const val& request) {
  const double thickness = number_of(request, "cartilage_mm", PoseRequest{}.cartilage_mm);
  if (thickness >= 0.0 && std::isfinite(thickness)) return thickness;
  throw std::invalid_argument("cartilage has a thickness of 0 mm or more");
}

Motion motion_request(const val& value) {
  return {angle_of(value, "flexion"), angle_of(value, "abduction"), angle_of(value, "internal_rotation")};
}

[[noreturn]] void refuse_sweep() {
  throw std::invalid_argument("a sweep has steps of 0.1 degrees or more, up to an angle above 0");
}

}  // namespace

HipParameters hip_request(const val& request) {
  HipParameters hip = hip_preset(request["name"].as<std::string>());
  const val given = request["parameters"];
  if (!is_given(given)) return hip;
  if (is_given(given["side"])) hip.side = parse_side(given["side"].as<std::string>());
  for (const HipParameter& parameter : hip_parameter_list())
    hip.*parameter.value = number_of(given, std::string(parameter.name).c_str(), hip.*parameter.value);
  require_in_range(hip);
  return hip;
}

JointInput meshes_request(const val& request) {
  JointInput input;
  input.ball = bone_request(request["ball"]);
  input.socket = bone_request(request["socket"]);
  if (is_given(request["centre"])) input.centre = vector_request(request["centre"]);
  if (is_given(request["side"])) input.side = parse_side(request["side"].as<std::string>());
  input.axes = axes_request(request).code;
  input.wording = {"as X, Y, Z", "ball and socket", "side and axes", ""};
  return input;
}

std::optional<LandmarkBytes> landmarks_request(const val& request) {
  const val file = request["landmarks"];
  if (!is_given(file)) return std::nullopt;
  return LandmarkBytes{file["name"].as<std::string>(), file["text"].as<std::string>()};
}

AxesChoice axes_request(const val& request) {
  std::optional<std::string> given;
  if (is_given(request["axes"])) given = request["axes"].as<std::string>();
  const SaidAxes ball = said_axes(request["ball"]);  // the first to be refused
  return agreed_axes(ball, said_axes(request["socket"]), given, "the field Axes");
}

TableSettings table_request(const val& request) {
  TableSettings settings;
  if (is_given(request["scheme"])) settings.scheme = request["scheme"].as<std::string>();
  settings.precision_deg = number_of(request, "precision_deg", settings.precision_deg);
  if (!(settings.precision_deg >= kFinest))
    throw std::invalid_argument("a page keeps no tables finer than 0.2 degrees; choose a coarser precision");
  if (!is_given(request["storage"])) return settings;
  const auto name = request["storage"].as<std::string>();
  const auto found = std::find(kStorages.begin(), kStorages.end(), name);
  if (found == kStorages.end())
    throw std::invalid_argument("unknown storage '" + name + "'; there are uint16, float, double");
  settings.storage = static_cast<Storage>(found - kStorages.begin());
  return settings;
}

PoseRequest pose_request(const val& request) {
  PoseRequest pose;
  pose.motion = motion_request(request);
  if (is_given(request["translation"])) pose.translation = vector_request(request["translation"]);
  pose.cartilage_mm = cartilage_of(request);
  return pose;
}

LimitRequest limit_request(const val& request) {
  LimitRequest limit;
  const auto name = request["motion"].as<std::string>();
  limit.growing = name;
  for (const NamedMotion& motion : named_motions()) {
    if (motion.name != name) continue;
    limit.growing = motion.growing;
    limit.motion = motion.name;
    limit.start = motion.start;
  }
  if (is_given(request["pose"])) limit.start = motion_request(request["pose"]);
  limit.largest_deg = number_of(request, "largest_deg", 150.0);
  if (is_given(request["translation"])) limit.translation = vector_request(request["translation"]);
  limit.cartilage_mm = cartilage_of(request);
  if (!(limit.largest_deg > 0.0)) refuse_sweep();
  return limit;
}

double step_request(const val& request) {
  const double step_deg = number_of(request, "step_deg", 1.0);
  if (!(step_deg >= 0.1)) refuse_sweep();
  return step_deg;
}

}  // namespace impinge
