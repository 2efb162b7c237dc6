// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/landmark_file.hpp"

#include <cctype>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/finite_number.hpp"

namespace impinge {
namespace {

using nlohmann::json;

constexpr const char* kAdvice = "give markups of 3D Slicer (.mrk.json) or a CSV label,x,y,z in mm";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw FileError(file, reason, kAdvice);
}

bool has(const std::string& label, std::string_view word) { return label.find(word) != label.npos; }

std::string lower(std::string_view text) {
  std::string label;
  for (const char c : text) label += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return label;
}

// The landmark that a label names; none of another.
std::optional<Vec3> Landmarks::*member(const std::string& label) {
  if (has(label, "asis") && has(label, "right")) return &Landmarks::asis_right;
  if (has(label, "asis") && has(label, "left")) return &Landmarks::asis_left;
  if (has(label, "tubercle") && has(label, "right")) return &Landmarks::pubic_tubercle_right;
  if (has(label, "tubercle") && has(label, "left")) return &Landmarks::pubic_tubercle_left;
  if (has(label, "epicondyle") && has(label, "medial")) return &Landmarks::epicondyle_medial;
  if (has(label, "epicondyle") && has(label, "lateral")) return &Landmarks::epicondyle_lateral;
  return nullptr;
}

void add(const std::filesystem::path& file, std::string_view label, const Vec3& place, Landmarks& found) {
  try {
    add_landmark(label, place, found);
  } catch (const std::invalid_argument& error) {
    refuse(file, error.what());
  }
}

void add_point(const std::filesystem::path& file, const json& point, const Eigen::Matrix3d& turn,
               Landmarks& found) {
  const json place = point.is_object() ? point.value("position", json()) : json();
  const bool numbers = place.is_array() && place.size() == 3 && place[0].is_number() &&
                       place[1].is_number() && place[2].is_number();
  if (!point.is_object() || !point.contains("label") || !point["label"].is_string()) return;
  if (!numbers) return;  // Slicer keeps points that are not placed yet
  add(file, point["label"].get<std::string>(), turn * Vec3(place[0], place[1], place[2]), found);
}

Landmarks of_markups(const std::filesystem::path& file, const std::string& bytes,
                     const Eigen::Matrix3d& axes) {
  const json text = json::parse(bytes, nullptr, /*allow_exceptions=*/false);
  if (!text.is_object() || !text.value("markups", json()).is_array()) refuse(file, "has no markups");
  Landmarks found;
  for (const json& markup : text["markups"]) {
    if (!markup.is_object() || !markup.value("controlPoints", json()).is_array()) continue;
    const json space = markup.value("coordinateSystem", json("LPS"));  // as Slicer takes it
    if (space != "LPS" && space != "RAS") refuse(file, "its coordinateSystem is neither LPS nor RAS");
    const Eigen::Matrix3d turn = axes.transpose() * input_to_joint(space.get<std::string>());
    for (const json& point : markup["controlPoints"]) add_point(file, point, turn, found);
  }
  return found;
}

Vec3 place_of(const std::filesystem::path& file, std::string_view numbers) {
  Vec3 place;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::string_view word = numbers.substr(0, numbers.find(','));
    const std::optional<double> number = finite_number(word);
    if (!number) refuse(file, "'" + std::string(numbers) + "' are not three numbers");
    place[k] = *number;
    numbers.remove_prefix(std::min(word.size() + 1, numbers.size()));
  }
  if (!numbers.empty()) refuse(file, "a line has more than a label and three numbers");
  return place;
}

Landmarks of_csv(const std::filesystem::path& file, std::string_view bytes) {
  Landmarks found;
  for (bool first = true; !bytes.empty(); first = false) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (first && line != "label,x,y,z") refuse(file, "does not begin with label,x,y,z");
    if (first || line.empty()) continue;
    const std::size_t comma = std::min(line.find(','), line.size());
    const std::string_view rest = line.substr(std::min(comma + 1, line.size()));
    if (member(lower(line.substr(0, comma))) != nullptr)
      add(file, line.substr(0, comma), place_of(file, rest), found);
  }
  return found;
}

}  // namespace

void add_landmark(std::string_view label, const Vec3& place, Landmarks& found) {
  const auto at = member(lower(label));
  if (at == nullptr) return;
  if (!place.allFinite()) throw std::invalid_argument("the landmark " + std::string(label) + " has no place");
  if (found.*at) throw std::invalid_argument("the landmark " + std::string(label) + " is there twice");
  found.*at = place;
}

Landmarks read_landmarks(const std::filesystem::path& file, const Eigen::Matrix3d& axes) {
  const std::string bytes = read_bytes(file);
  return lower(file.extension().string()) == ".json" ? of_markups(file, bytes, axes) : of_csv(file, bytes);
}

void use_landmarks(const Landmarks& landmarks, const std::string& from, std::optional<Side> side,
                   Joint& joint) {
  try {
    use_frames(joint, anatomical_frames(landmarks, joint.centre, side, input_to_joint(joint.axes)));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(from + ": " + error.what());
  }
}

void use_landmarks(const std::filesystem::path& file, std::optional<Side> side, Joint& joint) {
  use_landmarks(read_landmarks(file, input_to_joint(joint.axes)), file.string(), side, joint);
}

}  // namespace impinge
