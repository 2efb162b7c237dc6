// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests.hpp"

#include <cstdint>

#include "hip/hip_presets.hpp"
#include "mesh/raw_mesh.hpp"

namespace impinge {
namespace {

std::string text_in(const val& request, const char* name) { return request[name].as<std::string>(); }

template <class Number>
std::vector<Number> numbers_in(const val& request, const char* name) {
  return is_given(request[name]) ? emscripten::convertJSArrayToNumberVector<Number>(request[name])
                                 : std::vector<Number>();
}

NamedMesh mesh_request(const val& value) {
  const std::string name = text_in(value, "name");
  const auto positions = numbers_in<double>(value, "positions");
  const auto corners = numbers_in<std::uint32_t>(value, "faces");
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
  SaidAxes said{text_in(mesh, "name"), std::nullopt};
  if (!is_given(mesh["head"])) return said;
  const auto bytes = numbers_in<std::uint8_t>(mesh, "head");
  said.code = declared_axes(said.file, std::string(bytes.begin(), bytes.end()));
  return said;
}

}  // namespace

HipParameters hip_request(const val& request) {
  HipParameters hip = hip_preset(text_in(request, "name"));
  if (!is_given(request["parameters"])) return hip;
  const Json given = json_from(request["parameters"]);
  for (const auto& [name, value] : given.items())
    set_hip_parameter(hip, name + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
  return hip;
}

JointInput meshes_request(const val& request) {
  JointInput input;
  input.ball = bone_request(request["ball"]);
  input.socket = bone_request(request["socket"]);
  if (is_given(request["centre"]))
    read_json(json_from(request["centre"]), "centre", {}, input.centre.emplace());
  if (is_given(request["side"])) input.side = parse_side(text_in(request, "side"));
  input.axes = axes_request(request).code;
  input.wording = {"as X, Y, Z", "ball and socket", "side and axes", ""};
  return input;
}

std::optional<LandmarkBytes> landmarks_request(const val& request) {
  const val file = request["landmarks"];
  if (!is_given(file)) return std::nullopt;
  return LandmarkBytes{text_in(file, "name"), text_in(file, "text")};
}

AxesChoice axes_request(const val& request) {
  std::optional<std::string> given;
  if (is_given(request["axes"])) given = text_in(request, "axes");
  std::vector<SaidAxes> said{said_axes(request["ball"]), said_axes(request["socket"])};
  for (const char* bone : {"ball", "socket"}) {
    if (!is_given(request[bone]["parts"])) continue;
    for (const val& part : emscripten::vecFromJSArray<val>(request[bone]["parts"]))
      said.push_back(said_axes(part));
  }
  return agreed_axes(said, given, "the field Axes");
}

}  // namespace impinge
