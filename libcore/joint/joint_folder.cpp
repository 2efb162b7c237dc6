// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/joint_folder.hpp"

#include <algorithm>
#include <array>
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

// The mesh file of one of these names. Which of two is meant nobody can tell, but that what faces the other
// bone counts before the whole of it.
std::optional<fs::path> find_mesh(const fs::path& folder, std::initializer_list<const char*> names) {
  std::optional<fs::path> found;
  for (const char* name : names) {
    for (const std::string_view format : words_of<MeshFormat>) {
      const fs::path file = folder / (std::string(name) + '.' + std::string(format));
      if (!fs::is_regular_file(file)) continue;
      if (found && found->stem() != std::string(name) + "_facing")
        throw FileError(folder, "has both " + found->filename().string() + " and " + file.filename().string(),
                        "leave the one that is meant");
      if (!found) found = file;
    }
  }
  return found;
}

// Throws FileError for a mesh that a command wrote beside its answer, in the pose that was asked about.
void require_given(const fs::path& mesh) {
  const fs::path file = mesh.parent_path() / "summary.json";
  if (!fs::is_regular_file(file)) return;
  const Json told = Json::parse(read_bytes(file), nullptr, /*allow_exceptions=*/false);
  const Json files = told.is_object() ? told.value("files", Json()) : Json();
  if (std::find(files.begin(), files.end(), mesh.filename().string()) != files.end())
    throw FileError(mesh, "is of the answer in summary.json, and may be moved",
                    "give the mesh that was asked about");
}

// An axis code, given as such or by a text such as "+x = patient left, +y = posterior, +z = superior (LPS)".
// Any other text is refused, for without axes the meshes' headers would count, or RAS.
std::string axes_of(const std::string& text) {
  static const std::string axis(
      R"(\s*([+-])([xyz])\s*=\s*(?:patient\s+)?(right|left|anterior|posterior|superior|inferior)\s*)");
  static const std::regex three(axis + "," + axis + "," + axis + R"((?:\(.*\)\s*)?)");
  constexpr std::string_view kWays = "RLAPSI";  // each beside its opposite
  std::string code = text;
  if (std::smatch found; std::regex_match(text, found, three)) {
    code = "   ";
    for (std::size_t k = 1; k < found.size(); k += 3) {
      const std::size_t way = kWays.find(static_cast<char>(found.str(k + 2).front() - 'a' + 'A'));
      code[static_cast<std::size_t>(found.str(k + 1).front() - 'x')] =
          kWays[found.str(k) == "+" ? way : way ^ 1U];
    }
  }
  input_to_joint(code);
  return code;
}

// Throws std::runtime_error, one line, where the folder holds no joint.
JointFolder joint_in(const fs::path& subject) {
  const auto ball = find_mesh(subject, kBalls);
  const auto socket = find_mesh(subject, kSockets);
  if (!ball || !socket)
    throw std::runtime_error(subject.string() + " has no " + (ball ? "socket" : "ball") + " mesh");
  for (const fs::path& mesh : {*ball, *socket}) require_given(mesh);
  const fs::path file = subject / kSubject;
  JointDescription said;
  if (fs::is_regular_file(file)) {
    said = read_description(file, OtherKeys::of_data);
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

// Throws std::invalid_argument, one line, for a key without effect that was meant to have one.
void check_other_key(const std::string& key, const Json& value, OtherKeys others) {
  constexpr std::array<std::string_view, 5> kOfSession{"program", "commit", "page", "ball", "socket"};
  constexpr std::array<std::string_view, 3> kOfProgram{"overlap_mm", "ignore_rest_contact", "keep"};
  const auto starts = [&](std::string_view name) { return name.starts_with(key) || key.starts_with(name); };
  if (key == "unit" || key == "units") {
    if (value != "mm") throw std::invalid_argument(key + ": is " + value.dump() + "; give all lengths in mm");
    return;
  }
  if (std::find(kOfSession.begin(), kOfSession.end(), key) != kOfSession.end()) return;
  if (std::any_of(kOfProgram.begin(), kOfProgram.end(), starts))
    throw std::invalid_argument(key + ": is no key; it is an option of the command line");
  const std::vector<std::string_view> names = names_of_fields<JointDescription>();
  const auto cut = std::find_if(names.begin(), names.end(), starts);
  const std::string_view meant = cut != names.end() ? *cut : near_word(key, names);
  if (!meant.empty())
    throw std::invalid_argument(key + ": is no key; did you mean " + std::string(meant) + "?");
  if (others == OtherKeys::refused)
    throw std::invalid_argument(key + ": is no key; there are " + joined(names));
}

}  // namespace

JointDescription read_description(const fs::path& file, OtherKeys others) {
  const Json given = Json::parse(read_bytes(file), nullptr, /*allow_exceptions=*/false);
  if (!given.is_object()) throw FileError(file, "is no JSON object", "write one, as {\"side\": \"left\"}");
  JointDescription said;
  try {
    for (const auto& [key, value] : given.items()) {
      if (key == "landmarks" && value.is_array())
        throw std::invalid_argument("landmarks: are one file; name it");
      if (!read_field(key, value, said)) check_other_key(key, value, others);
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
