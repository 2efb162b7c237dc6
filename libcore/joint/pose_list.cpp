// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/pose_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/finite_number.hpp"
#include "gap/nearest_rotation.hpp"

namespace impinge {
namespace {

constexpr const char* kAdvice =
    "give a CSV with a header of motions (as flexion,internal_rotation) and degrees below it, a CSV of "
    "matrices of 12 or 16 numbers a line, or a motion of OpenSim (.mot, .sto)";

constexpr std::size_t kMostPoses = 10'000'000;  // of a grid

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

// As programs write what was not tracked.
bool is_missing(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  const auto letter = [&](std::size_t k) { return static_cast<char>(word[k] | 0x20); };
  return word.empty() || (word.size() == 3 && letter(0) == 'n' && letter(1) == 'a' && letter(2) == 'n');
}

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

// std::invalid_argument unless each of the three angles is given by one column at most.
void require_one_each(const std::vector<PoseColumn>& columns) {
  for (const PoseColumn& a : columns) {
    for (const PoseColumn& b : columns) {
      if (&a < &b && a.motion && b.motion && a.motion->angle == b.motion->angle)
        throw std::invalid_argument(in_quotes(a.name) + " and " + in_quotes(b.name) +
                                    " are the same angle; give it once");
    }
  }
}

// Lines of a file, with their numbers, and words in them.
class Lines {
 public:
  Lines(const std::filesystem::path& file, std::string_view bytes, std::string_view separators)
      : file_(file), rest_(bytes), separators_(separators) {}

  // The next line that is not blank.
  bool next() {
    while (!rest_.empty()) {
      line_ = rest_.substr(0, rest_.find('\n'));
      rest_.remove_prefix(std::min(line_.size() + 1, rest_.size()));
      if (line_.ends_with('\r')) line_.remove_suffix(1);
      ++number_;
      if (line_.find_first_not_of(" \t") != line_.npos) return true;
    }
    return false;
  }
  std::string_view line() const { return line_; }

  std::vector<std::string_view> words() const {
    const bool blanks = separators_ != ",";  // any number of them is one
    std::vector<std::string_view> words;
    for (std::size_t from = 0; from <= line_.size();) {
      const std::size_t end = std::min(line_.find_first_of(separators_, from), line_.size());
      std::string_view word = line_.substr(from, end - from);
      while (word.starts_with(' ')) word.remove_prefix(1);
      while (word.ends_with(' ')) word.remove_suffix(1);
      if (!blanks || !word.empty()) words.push_back(word);
      from = end + 1;
    }
    return words;
  }

  // Is it a header, with text and without numbers?
  bool names() const {
    const std::vector<std::string_view> all = words();
    return std::ranges::any_of(all, [](std::string_view word) { return !is_missing(word); }) &&
           std::ranges::none_of(all, [](std::string_view word) { return finite_number(word).has_value(); });
  }

  // A finite number for each word, NaN for a missing one.
  std::vector<double> numbers() const {
    std::vector<double> numbers;
    for (const std::string_view word : words()) {
      const auto value = is_missing(word) ? std::optional(kMissing) : finite_number(word);
      if (!value) refuse(in_quotes(word) + " is no number");
      numbers.push_back(*value);
    }
    return numbers;
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw FileError(file_, "line " + std::to_string(number_) + ": " + reason, kAdvice);
  }

 private:
  const std::filesystem::path& file_;
  std::string_view rest_;
  std::string_view separators_;
  std::string_view line_;
  std::size_t number_ = 0;
};

void add_angles(const Lines& lines, const std::vector<double>& row, PoseList& list) {
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (list.columns[k].motion != nullptr && std::abs(row[k]) > kLargestAngle)
      lines.refuse("an angle of " + list.columns[k].name + " is not within 180 degrees of 0");
    list.values.push_back(row[k]);
  }
}

void add_matrix(const Lines& lines, const std::vector<double>& row, PoseList& list) {
  if (row.size() != 12 && row.size() != 16)
    lines.refuse(std::to_string(row.size()) + " numbers are no matrix");
  if (std::ranges::any_of(row, [](double x) { return std::isnan(x); })) {
    list.values.insert(list.values.end(), 12, kMissing);
    return;
  }
  if (row.size() == 16 && (row[12] != 0.0 || row[13] != 0.0 || row[14] != 0.0 || row[15] != 1.0))
    lines.refuse("the last row of a matrix is 0,0,0,1");
  Eigen::Matrix3d given;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) given(i, k) = row[static_cast<std::size_t>(4 * i + k)];
  }
  const std::optional<Eigen::Matrix3d> nearest = nearest_rotation(given);
  if (!nearest) lines.refuse("the matrix does not turn only: it is more than 0.0001 off from any rotation");
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) list.values.push_back((*nearest)(i, k));
    list.values.push_back(row[static_cast<std::size_t>(4 * i + 3)]);
  }
}

void require_pose(const std::filesystem::path& file, const PoseList& list) {
  for (std::size_t row = 0; row < list.size(); ++row) {
    if (list.tracked(row)) return;
  }
  throw FileError(file, list.values.empty() ? "holds no pose" : "has a number missing in every row", kAdvice);
}

PoseList read_csv(const std::filesystem::path& file, std::string_view bytes) {
  Lines lines(file, bytes, ",");
  if (!lines.next()) throw FileError(file, "holds no pose", kAdvice);
  PoseList list;
  const std::vector<std::string_view> head = lines.words();
  const bool matrices = head.size() == 12 || head.size() == 16;
  if (!matrices) {
    for (const std::string_view word : head) {
      try {
        list.columns.push_back({std::string(word), &motion_name(word)});
        require_one_each(list.columns);
      } catch (const std::invalid_argument& error) {
        lines.refuse(error.what());
      }
    }
  }
  for (bool more = !lines.names() || lines.next(); more; more = lines.next()) {
    const std::vector<double> row = lines.numbers();
    if (matrices) {
      add_matrix(lines, row, list);
    } else if (row.size() != head.size()) {
      lines.refuse(std::to_string(row.size()) + " numbers below " + std::to_string(head.size()) + " names");
    } else {
      add_angles(lines, row, list);
    }
  }
  require_pose(file, list);
  return list;
}

// "hip_flexion_r" of "/jointset/hip_r/hip_flexion_r/value".
std::string_view coordinate(std::string_view label) {
  if (!label.ends_with("/value")) return label;
  label.remove_suffix(std::string_view("/value").size());
  return label.substr(label.rfind('/') + 1);
}

// What a head says of inDegrees: degrees for one unit of its angles.
double degrees_a_unit(const std::filesystem::path& file, Lines& lines) {
  std::optional<double> unit;
  while (lines.next() && lines.line() != "endheader") {
    if (lines.line() == "inDegrees=yes") unit = 1.0;
    if (lines.line() == "inDegrees=no") unit = 1.0 / kDegree;
  }
  if (lines.line() != "endheader") throw FileError(file, "has no line endheader", kAdvice);
  if (!unit)
    throw FileError(file, "says neither inDegrees=yes nor inDegrees=no before endheader",
                    "add the line that is true");
  return *unit;
}

PoseList read_opensim(const std::filesystem::path& file, std::string_view bytes, std::optional<Side> side) {
  if (!side)
    throw FileError(file, "is a motion of OpenSim, which has angles of two hips", "say which with --side");
  const char* suffix = *side == Side::left ? "_l" : "_r";
  const std::array<PoseColumn, 3> wanted{PoseColumn{"hip_flexion", &motion_name("flexion")},
                                         PoseColumn{"hip_adduction", &motion_name("adduction")},
                                         PoseColumn{"hip_rotation", &motion_name("internal_rotation")}};
  Lines lines(file, bytes, " \t");
  const double unit = degrees_a_unit(file, lines);
  PoseList list;
  std::vector<std::size_t> from;  // the file's column of each of the list's
  lines.next();
  const std::vector<std::string_view> labels = lines.words();
  const auto take = [&](std::string_view name, const MotionName* motion) {
    const auto at = std::find_if(labels.begin(), labels.end(),
                                 [&](std::string_view label) { return coordinate(label) == name; });
    if (at == labels.end()) lines.refuse("there is no column " + std::string(name));
    from.push_back(static_cast<std::size_t>(at - labels.begin()));
    list.columns.push_back({std::string(name), motion});
  };
  take("time", nullptr);
  for (const PoseColumn& column : wanted) take(column.name + suffix, column.motion);
  while (lines.next()) {
    const std::vector<double> all = lines.numbers();
    if (all.size() != labels.size())
      lines.refuse(std::to_string(all.size()) + " numbers below " + std::to_string(labels.size()) + " names");
    std::vector<double> row;
    for (std::size_t k = 0; k < from.size(); ++k) row.push_back(all[from[k]] * (k == 0 ? 1.0 : unit));
    add_angles(lines, row, list);
  }
  require_pose(file, list);
  return list;
}

// One angle of a grid.
struct Axis {
  PoseColumn column;
  double first = 0.0;
  double last = 0.0;
  std::size_t count = 1;

  // Without the noise of division, which would show in files.
  double angle(std::size_t step) const {
    if (step == 0) return first;
    const double part = static_cast<double>(step) / static_cast<double>(count - 1);
    return std::round((first + part * (last - first)) * 1e9) / 1e9;
  }
};

Axis parse_axis(std::string_view text) {
  const auto refuse = [&](const std::string& why) -> void {
    throw std::invalid_argument(in_quotes(text) + " " + why +
                                "; write NAME=FIRST..LAST/STEP or NAME=ANGLE, as flexion=0..120/1");
  };
  const auto angle = [&](std::string_view word) {
    const auto value = finite_number(word);
    if (!value || std::abs(*value) > kLargestAngle)
      refuse("holds " + in_quotes(word) + ", which is no angle from -180 to 180");
    return *value;
  };
  const std::size_t equals = text.find('=');
  if (equals == text.npos) refuse("is no range of a motion");
  Axis axis;
  axis.column = {std::string(text.substr(0, equals)), &motion_name(text.substr(0, equals))};
  const std::string_view range = text.substr(equals + 1);
  const std::size_t dots = range.find("..");
  axis.first = angle(range.substr(0, dots));
  if (dots == range.npos) return axis;
  const std::size_t slash = range.find('/', dots);
  if (slash == range.npos) refuse("has no step");
  axis.last = angle(range.substr(dots + 2, slash - dots - 2));
  const auto step = finite_number(range.substr(slash + 1));
  if (!step || !(*step > 0.0)) refuse("has no step above 0");
  const double steps = std::abs(axis.last - axis.first) / *step;
  if (!(steps < kMostPoses)) refuse("has more than ten million steps");
  if (std::abs(steps - std::round(steps)) > 1e-6) refuse("does not meet its last angle in whole steps");
  axis.count = static_cast<std::size_t>(std::lround(steps)) + 1;
  return axis;
}

}  // namespace

bool PoseList::tracked(std::size_t row) const {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * width());
  return std::all_of(first, first + static_cast<std::ptrdiff_t>(width()),
                     [](double x) { return !std::isnan(x); });
}

bool PoseList::needs_side() const {
  return std::ranges::any_of(columns, [](const PoseColumn& column) {
    return column.motion != nullptr && column.motion->angle != &Motion::flexion;
  });
}

Motion PoseList::motion(std::size_t row) const {
  Motion motion;
  for (std::size_t k = 0; k < width(); ++k) {
    if (const MotionName* name = columns[k].motion)
      motion.*(name->angle) = name->sign * values[row * width() + k];
  }
  return motion;
}

Eigen::Matrix3d PoseList::rotation(std::size_t row) const {
  const double* m = &values[row * width()];
  return Eigen::Matrix3d{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}};
}

Vec3 PoseList::translation(std::size_t row) const {
  const double* m = &values[row * width()];
  return {m[3], m[7], m[11]};
}

PoseList parse_pose_grid(std::string_view text) {
  std::vector<Axis> axes;
  PoseList list;
  std::size_t poses = 1;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    axes.push_back(parse_axis(text.substr(0, comma)));
    list.columns.push_back(axes.back().column);
    require_one_each(list.columns);
    poses *= axes.back().count;
    if (poses > kMostPoses)
      throw std::invalid_argument("more than ten million poses; give longer steps or shorter ranges");
    more = comma != text.npos;
    text.remove_prefix(more ? comma + 1 : 0);
  }
  list.values.reserve(poses * axes.size());
  for (std::size_t pose = 0; pose < poses; ++pose) {
    std::size_t slower = poses;  // poses of the angles from this one on
    for (const Axis& axis : axes) {
      const std::size_t faster = slower / axis.count;
      list.values.push_back(axis.angle(pose % slower / faster));
      slower = faster;
    }
  }
  return list;
}

PoseList read_poses(const std::filesystem::path& file, std::optional<Side> side) {
  const std::string whole = read_bytes(file);
  std::string_view bytes = whole;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);  // byte order mark of UTF-8
  const std::string kind = file.extension().string();
  return kind == ".mot" || kind == ".sto" ? read_opensim(file, bytes, side) : read_csv(file, bytes);
}

}  // namespace impinge
