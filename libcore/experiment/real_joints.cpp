// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/real_joints.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "experiment/atomic_file.hpp"
#include "mesh/io.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

constexpr std::array kBalls{"femoral_head.ply", "humeral_head.ply"};
constexpr std::array kSockets{"acetabulum_facing.ply", "glenoid_facing.ply"};
constexpr std::array kSubjects{"subject.json"};
constexpr const char* kCentre = "center_of_rotation_mm";

// The first of these files that is there.
template <std::size_t N>
std::optional<fs::path> first_of(const fs::path& folder, const std::array<const char*, N>& names) {
  for (const char* name : names) {
    if (fs::is_regular_file(folder / name)) return folder / name;
  }
  return std::nullopt;
}

Vec3 centre_in(const fs::path& file) {
  const nlohmann::json subject = nlohmann::json::parse(read_file(file), nullptr, /*allow_exceptions=*/false);
  const nlohmann::json centre =
      subject.is_object() ? subject.value(kCentre, nlohmann::json()) : nlohmann::json();
  const bool numbers = std::all_of(centre.begin(), centre.end(), [](const auto& x) { return x.is_number(); });
  if (!centre.is_array() || centre.size() != 3 || !numbers) {
    throw std::runtime_error(file.string() + ": no " + kCentre +
                             ": give the centre of rotation as [x, y, z]");
  }
  return {centre[0].get<double>(), centre[1].get<double>(), centre[2].get<double>()};
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
    const auto ball = first_of(subject, kBalls);
    const auto socket = first_of(subject, kSockets);
    const auto description = first_of(subject, kSubjects);
    if (!ball || !socket || !description) {
      progress.say("left out: " + subject.string() + " has no " +
                   (!ball     ? "ball mesh"
                    : !socket ? "socket mesh"
                              : kSubjects.front()));
      continue;
    }
    const Vec3 centre = centre_in(*description);
    joints.push_back({subject.filename().string(),
                      {relative_to(read_mesh(*ball), centre), relative_to(read_mesh(*socket), centre)}});
  }
  if (joints.empty()) {
    throw std::runtime_error(folder.string() +
                             ": no folder in it holds a joint: give one folder a subject with " +
                             kBalls.front() + ", " + kSockets.front() + " and " + kSubjects.front());
  }
  return joints;
}

}  // namespace impinge
