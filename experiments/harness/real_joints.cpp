// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/real_joints.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <regex>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "files/file_bytes.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/io.hpp"

namespace impinge::lab {
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

// The axis code of a text such as "+x = patient left, +y = posterior, +z = superior"; RAS without one.
std::string axes_of(const nlohmann::json& subject, const fs::path& file) {
  static const std::regex way("= (?:patient )?(right|left|anterior|posterior|superior|inferior)");
  const std::string text = text_of(subject, "axes");
  std::string code;
  for (auto end = std::sregex_iterator(text.begin(), text.end(), way); end != std::sregex_iterator(); ++end)
    code += static_cast<char>(std::toupper(static_cast<unsigned char>((*end)[1].str().front())));
  if (code.empty()) return "RAS";
  try {
    input_to_joint(code);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file.string() + ": axes: " + error.what());
  }
  return code;
}

std::optional<Side> side_of(const nlohmann::json& subject) {
  const std::string side = text_of(subject, "side");
  return side == "left" || side == "right" ? std::optional(parse_side(side)) : std::nullopt;
}

Vec3 fitted_centre(const TriangleMesh& ball, const fs::path& file) {
  try {
    return fit_ball(ball).centre;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file.string() + ": " + error.what() + "; give the centre in " + kSubject);
  }
}

}  // namespace

std::vector<RealJoint> read_real_joints(const fs::path& folder, Progress& progress) {
  std::vector<fs::path> subjects;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) subjects.push_back(entry.path());
  }
  std::sort(subjects.begin(), subjects.end());
  std::vector<RealJoint> joints;
  for (const fs::path& subject : subjects) {
    const auto ball_file = find_mesh(subject, kBalls);
    const auto socket_file = find_mesh(subject, kSockets);
    if (!ball_file || !socket_file) {
      progress.say("left out: " + subject.string() + " has no " + (ball_file ? "socket" : "ball") + " mesh");
      continue;
    }
    const TriangleMesh ball = read_mesh(*ball_file);
    const nlohmann::json text = description(subject);
    const std::optional<Vec3> described = described_centre(text, subject / kSubject);
    const Vec3 centre = described ? *described : fitted_centre(ball, *ball_file);
    joints.push_back({subject.filename().string(),
                      {relative_to(ball, centre), relative_to(read_mesh(*socket_file), centre)},
                      centre,
                      described.has_value(),
                      described_radius(text),
                      side_of(text),
                      axes_of(text, subject / kSubject)});
  }
  if (joints.empty()) {
    throw std::runtime_error(folder.string() +
                             ": no folder in it holds a joint: give one folder a subject with a ball (" +
                             listed(kBalls) + ") and a socket (" + listed(kSockets) + ")");
  }
  return joints;
}

BallSocketPair in_joint_frame(const RealJoint& joint) {
  const Eigen::Matrix3d axes = input_to_joint(joint.axes);
  BallSocketPair meshes = joint.meshes;
  for (TriangleMesh* mesh : {&meshes.ball, &meshes.socket}) {
    for (Vec3& x : mesh->vertices) x = axes * x;
  }
  return meshes;
}

}  // namespace impinge::lab
