// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/joint_folder.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <regex>
#include <stdexcept>
#include <system_error>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/joined.hpp"
#include "joint/document.hpp"
#include "mesh/mesh_format.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

constexpr std::initializer_list<const char*> kBalls{"ball", "femoral_head", "humeral_head"};
constexpr std::initializer_list<const char*> kSockets{"socket", "acetabulum_facing", "glenoid_facing",
                                                      "acetabulum", "glenoid"};
constexpr const char* kSubject = "subject.json";

// The first mesh file of these names that is there.
std::optional<fs::path> find_mesh(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (const std::string_view format : words_of<MeshFormat>) {
      const fs::path file = folder / (std::string(name) + '.' + std::string(format));
      if (fs::is_regular_file(file)) return file;
    }
  }
  return std::nullopt;
}

// An axis code, given as such or by a text such as "+x = patient left, +y = posterior, +z = superior".
std::optional<std::string> axes_of(const std::string& text) {
  static const std::regex way("= (?:patient )?(right|left|anterior|posterior|superior|inferior)");
  std::string code;
  for (auto end = std::sregex_iterator(text.begin(), text.end(), way); end != std::sregex_iterator(); ++end)
    code += static_cast<char>(std::toupper(static_cast<unsigned char>((*end)[1].str().front())));
  if (code.empty() && text.size() == 3) code = text;
  if (code.empty()) return std::nullopt;
  input_to_joint(code);
  return code;
}

// Throws std::runtime_error, one line, where the folder holds no joint.
JointFolder joint_in(const fs::path& subject) {
  const auto ball = find_mesh(subject, kBalls);
  const auto socket = find_mesh(subject, kSockets);
  if (!ball || !socket)
    throw std::runtime_error(subject.string() + " has no " + (ball ? "socket" : "ball") + " mesh");
  const fs::path file = subject / kSubject;
  JointDescription said;
  if (fs::is_regular_file(file)) {
    said = read_description(file);
    if (!said.centre)
      throw std::runtime_error(file.string() +
                               ": no center_of_rotation_mm: give the centre of rotation as [x, y, z], or "
                               "remove the file to have it fitted");
  }
  return {said, subject.filename().string(), *ball, *socket};
}

// The folders in a folder, in the order of their names.
std::vector<fs::path> folders_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  if (error)
    throw FileError(folder, "cannot be read, " + error.message(), "give a folder with one folder a joint");
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace

JointDescription read_description(const fs::path& file) {
  const Json given = Json::parse(read_bytes(file), nullptr, /*allow_exceptions=*/false);
  if (!given.is_object()) throw FileError(file, "is no JSON object", "write one, as {\"side\": \"left\"}");
  JointDescription said;
  try {
    for (const auto& [key, value] : given.items()) {
      if (key == "landmarks" && value.is_array())
        throw std::invalid_argument("landmarks: are one file; name it");
      if (read_field(key, value, said)) continue;
      const std::string_view meant = near_word(key, names_of_fields<JointDescription>());
      if (!meant.empty())
        throw std::invalid_argument(key + ": is no key; did you mean " + std::string(meant) + "?");
    }
    if (said.axes) said.axes = axes_of(*said.axes);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
  const fs::path folder = file.parent_path();
  if (said.landmarks) said.landmarks = folder / *said.landmarks;
  for (auto* parts : {&said.ball_parts, &said.socket_parts})
    for (fs::path& part : *parts) part = folder / part;
  return said;
}

JointFolders find_joints(const fs::path& folder) {
  JointFolders found;
  for (const fs::path& subject : folders_in(folder)) {
    try {
      found.joints.push_back(joint_in(subject));
    } catch (const std::runtime_error& error) {
      found.left_out.emplace_back(error.what());
    }
  }
  if (found.joints.empty()) {
    throw std::runtime_error(folder.string() +
                             ": no folder in it holds a joint: give one folder a subject with a ball (" +
                             joined(kBalls) + ") and a socket (" + joined(kSockets) + ")" +
                             (found.left_out.empty() ? "" : "; " + found.left_out.front()));
  }
  return found;
}

}  // namespace impinge
