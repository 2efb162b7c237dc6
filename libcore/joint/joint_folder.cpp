// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/joint_folder.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <regex>
#include <stdexcept>
#include <system_error>

#include <nlohmann/json.hpp>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

constexpr std::initializer_list<const char*> kBalls{"ball", "femoral_head", "humeral_head"};
constexpr std::initializer_list<const char*> kSockets{"socket", "acetabulum_facing", "glenoid_facing",
                                                      "acetabulum", "glenoid"};
constexpr std::initializer_list<const char*> kFormats{".ply", ".stl", ".obj", ".off"};
constexpr const char* kSubject = "subject.json";
constexpr const char* kCentre = "center_of_rotation_mm";
constexpr const char* kRadius = "radius_mm";

// The first of these meshes that is there.
std::optional<fs::path> find_mesh(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (const char* format : kFormats) {
      const fs::path file = folder / (std::string(name) + format);
      if (fs::is_regular_file(file)) return file;
    }
  }
  return std::nullopt;
}

std::string listed(std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

// What the subject's description says, empty where there is none.
nlohmann::json description(const fs::path& folder) {
  const fs::path file = folder / kSubject;
  if (!fs::is_regular_file(file)) return nullptr;
  const nlohmann::json subject = nlohmann::json::parse(read_bytes(file), nullptr, /*allow_exceptions=*/false);
  return subject.is_object() ? subject : nlohmann::json::object();
}

// The centre that it gives, if there is a description.
std::optional<Vec3> described_centre(const nlohmann::json& subject, const fs::path& file) {
  if (subject.is_null()) return std::nullopt;
  const nlohmann::json centre = subject.value(kCentre, nlohmann::json());
  const bool numbers = std::all_of(centre.begin(), centre.end(), [](const auto& x) { return x.is_number(); });
  if (!centre.is_array() || centre.size() != 3 || !numbers) {
    throw std::runtime_error(
        file.string() + ": no " + kCentre +
        ": give the centre of rotation as [x, y, z], or remove the file to have it fitted");
  }
  return Vec3(centre[0].get<double>(), centre[1].get<double>(), centre[2].get<double>());
}

std::optional<double> described_radius(const nlohmann::json& subject) {
  if (subject.is_null()) return std::nullopt;
  const nlohmann::json radius = subject.value(kRadius, nlohmann::json());
  return radius.is_number() ? std::optional(radius.get<double>()) : std::nullopt;
}

std::string text_of(const nlohmann::json& subject, const char* key) {
  if (!subject.is_object() || !subject.contains(key) || !subject[key].is_string()) return "";
  return subject[key].get<std::string>();
}

// The axis code of a text such as "+x = patient left, +y = posterior, +z = superior"; none without one.
std::optional<std::string> axes_of(const nlohmann::json& subject, const fs::path& file) {
  static const std::regex way("= (?:patient )?(right|left|anterior|posterior|superior|inferior)");
  const std::string text = text_of(subject, "axes");
  std::string code;
  for (auto end = std::sregex_iterator(text.begin(), text.end(), way); end != std::sregex_iterator(); ++end)
    code += static_cast<char>(std::toupper(static_cast<unsigned char>((*end)[1].str().front())));
  if (code.empty()) return std::nullopt;
  try {
    input_to_joint(code);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file.string() + ": axes: " + error.what());
  }
  return code;
}

std::optional<Side> described_side(const nlohmann::json& subject) {
  const std::string side = text_of(subject, "side");
  return side == "left" || side == "right" ? std::optional(parse_side(side)) : std::nullopt;
}

// std::runtime_error, one line, where it holds none.
JointFolder joint_in(const fs::path& subject) {
  const auto ball = find_mesh(subject, kBalls);
  const auto socket = find_mesh(subject, kSockets);
  if (!ball || !socket)
    throw std::runtime_error(subject.string() + " has no " + (ball ? "socket" : "ball") + " mesh");
  const nlohmann::json text = description(subject);
  const fs::path file = subject / kSubject;
  return {subject.filename().string(),
          *ball,
          *socket,
          described_centre(text, file),
          described_radius(text),
          described_side(text),
          axes_of(text, file)};
}

// The folders in it, in the order of their names.
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
                             listed(kBalls) + ") and a socket (" + listed(kSockets) + ")" +
                             (found.left_out.empty() ? "" : "; " + found.left_out.front()));
  }
  return found;
}

}  // namespace impinge
