// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/landmark_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/delimited.hpp"
#include "files/file_bytes.hpp"
#include "files/file_error.hpp"

namespace impinge {
namespace {

using nlohmann::json;

constexpr std::size_t kMostOthers = 200;  // characters of labels in one message
constexpr const char* kAdvice =
    "give markups of 3D Slicer (.mrk.json, .fcsv, or its table label,r,a,s or label,l,p,s) or a CSV "
    "label,x,y,z in mm";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw FileError(file, reason, kAdvice);
}

bool has(const std::string& label, std::string_view word) { return label.find(word) != label.npos; }

std::string lower(std::string_view text) {
  std::string label;
  for (const char c : text) label += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return label;
}

// The landmark that a label names; null for any other label.
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
    const json space = markup.value("coordinateSystem", json("LPS"));  // Slicer's default
    if (space != "LPS" && space != "RAS") refuse(file, "its coordinateSystem is neither LPS nor RAS");
    const Eigen::Matrix3d turn = axes.transpose() * input_to_joint(space.get<std::string>());
    for (const json& point : markup["controlPoints"]) add_point(file, point, turn, found);
  }
  return found;
}

// Where the columns of a table are.
struct LandmarkColumns {
  std::size_t label = 0;
  std::array<std::size_t, 3> place{};
  std::optional<std::size_t> defined;  // 0 there for a point that is not placed
  std::size_t names = 0;
  std::string_view axes;  // axes of the places; empty if they are the meshes' axes
};

// None unless there are columns for a label and a place.
std::optional<LandmarkColumns> landmark_columns(std::string_view head, char separator) {
  const std::vector<std::string_view> words = delimited_words(head, separator);
  const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto at =
        std::find_if(words.begin(), words.end(), [&](std::string_view word) { return lower(word) == name; });
    return at == words.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - words.begin()));
  };
  const std::optional<std::size_t> label = find("label");
  for (const auto& [names, axes] : {std::pair("xyz", ""), {"ras", "RAS"}, {"lps", "LPS"}}) {
    const auto x = find({names, 1});
    const auto y = find({names + 1, 1});
    const auto z = find({names + 2, 1});
    if (label && x && y && z)
      return LandmarkColumns{*label, {*x, *y, *z}, find("defined"), words.size(), axes};
  }
  return std::nullopt;
}

// The value in a line "# KEY = VALUE" of a .fcsv; empty for other lines.
std::string_view comment_value(std::string_view line, std::string_view key) {
  const std::size_t equals = line.find('=');
  if (equals == line.npos || delimited_words(line.substr(1, equals - 1), '=')[0] != key) return {};
  return delimited_words(line.substr(equals + 1), '=')[0];
}

// A table whose columns are named by a header, or in a .fcsv by a comment.
class LandmarkTable {
 public:
  LandmarkTable(const std::filesystem::path& file, std::string_view bytes, const Eigen::Matrix3d& axes)
      : file_(file), lines_(bytes), axes_(axes), fiducials_(lower(file.extension().string()) == ".fcsv") {
    if (fiducials_) columns_ = landmark_columns("label,x,y,z,sel,vis", separator_);
  }

  Landmarks read() {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (fiducials_ && line.starts_with('#')) {
        read_comment(line);
      } else if (!columns_) {
        separator_ = separator_of(line);
        columns_ = landmark_columns(line, separator_);
        if (!columns_) refuse_line("does not name the columns label,x,y,z, label,r,a,s or label,l,p,s");
      } else {
        read_row(delimited_words(line, separator_));
      }
    }
    return found_;
  }

 private:
  [[noreturn]] void refuse_line(const std::string& reason) const {
    refuse(file_, "line " + std::to_string(lines_.number()) + " " + reason);
  }
  void read_comment(std::string_view line) {
    const std::string_view columns = comment_value(line, "columns");
    if (!columns.empty()) columns_ = landmark_columns(columns, separator_);
    if (!columns_) refuse_line("does not name the columns label, x, y and z");
    const std::string_view system = comment_value(line, "CoordinateSystem");
    if (system.empty()) return;
    if (system != "0" && system != "RAS" && system != "1" && system != "LPS")
      refuse_line("has a CoordinateSystem that is neither RAS (0) nor LPS (1)");
    fiducial_axes_ = system == "1" || system == "LPS" ? "LPS" : "RAS";
  }
  // A .fcsv has this number behind the columns that it names; 2 means placed.
  bool is_placed(const std::vector<std::string_view>& words) const {
    if (columns_->defined && *columns_->defined < words.size()) return words[*columns_->defined] != "0";
    return !fiducials_ || words.size() <= columns_->names || words[columns_->names] == "2";
  }
  void read_row(const std::vector<std::string_view>& words) {
    const LandmarkColumns& at = *columns_;
    const std::size_t needed = std::max({at.label, at.place[0], at.place[1], at.place[2]}) + 1;
    if (words.size() < needed || (!fiducials_ && words.size() != at.names))
      refuse_line("has " + std::to_string(words.size()) + " fields below " + std::to_string(at.names) +
                  " names");
    if (!is_placed(words)) return;
    Vec3 place;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<double> number = delimited_number(words[at.place[k]], separator_);
      if (!number) refuse_line("has '" + std::string(words[at.place[k]]) + "', which is no number");
      place[static_cast<Eigen::Index>(k)] = *number;
    }
    const std::string_view axes = fiducials_ ? fiducial_axes_ : at.axes;
    if (!axes.empty()) place = (axes_.transpose() * input_to_joint(std::string(axes)) * place).eval();
    add(file_, words[at.label], place, found_);
  }

  const std::filesystem::path& file_;
  NumberedLines lines_;
  const Eigen::Matrix3d& axes_;
  bool fiducials_;
  std::string_view fiducial_axes_ = "RAS";  // Slicer's frame before its files named one
  char separator_ = ',';
  std::optional<LandmarkColumns> columns_;
  Landmarks found_;
};

}  // namespace

void add_landmark(std::string_view label, const Vec3& place, Landmarks& found) {
  const auto at = member(lower(label));
  if (at == nullptr) {
    if (found.others.size() < kMostOthers)
      found.others += (found.others.empty() ? "" : ", ") + std::string(label);
    return;
  }
  if (!place.allFinite()) throw std::invalid_argument("the landmark " + std::string(label) + " has no place");
  if (found.*at) throw std::invalid_argument("the landmark " + std::string(label) + " is there twice");
  found.*at = place;
}

Landmarks read_landmarks(const std::filesystem::path& file, const Eigen::Matrix3d& axes) {
  return read_landmarks(file, read_bytes(file), axes);
}

Landmarks read_landmarks(const std::filesystem::path& file, const std::string& bytes,
                         const Eigen::Matrix3d& axes) {
  Landmarks found = lower(file.extension().string()) == ".json" ? of_markups(file, bytes, axes)
                                                                : LandmarkTable(file, bytes, axes).read();
  if (!found.asis_right && !found.asis_left && !found.pubic_tubercle_right && !found.pubic_tubercle_left &&
      !found.epicondyle_medial && !found.epicondyle_lateral && !found.others.empty())
    throw FileError(file, "its labels are of no landmark: " + found.others,
                    "call them asis_right, asis_left, pubic_tubercle_right, pubic_tubercle_left, "
                    "epicondyle_medial, epicondyle_lateral");
  return found;
}

void use_landmarks(const Landmarks& landmarks, const std::string& from, std::optional<Side> side,
                   Joint& joint) {
  try {
    use_frames(joint, anatomical_frames(landmarks, joint.centre, side, input_to_joint(joint.axes)));
    if (!joint.frames->femur && !landmarks.others.empty())
      joint.warnings.push_back(
          from + ": has no epicondyles, so angles are counted from the scan; its labels " + landmarks.others +
          " are of no landmark: if two of them are meant, call them epicondyle_medial and "
          "epicondyle_lateral");
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(from + ": " + error.what());
  }
}

void use_landmarks(const std::filesystem::path& file, std::optional<Side> side, Joint& joint) {
  use_landmarks(read_landmarks(file, input_to_joint(joint.axes)), file.string(), side, joint);
}

}  // namespace impinge
