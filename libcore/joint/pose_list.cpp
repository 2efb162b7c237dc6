// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/pose_list.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include "files/finite_number.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostPoses = 10'000'000;  // in a grid

// A name that a column may have, its kind, and the number of the pose that it gives.
struct NumberName {
  PoseKind kind;
  std::string_view name;
  int number;
  double sign = 1.0;
};
constexpr std::array<NumberName, 21> kNames{{{PoseKind::hip, "flexion", 0},
                                             {PoseKind::hip, "extension", 0, -1.0},
                                             {PoseKind::hip, "abduction", 1},
                                             {PoseKind::hip, "adduction", 1, -1.0},
                                             {PoseKind::hip, "internal_rotation", 2},
                                             {PoseKind::hip, "external_rotation", 2, -1.0},
                                             {PoseKind::hip, "tx", 3},
                                             {PoseKind::hip, "ty", 4},
                                             {PoseKind::hip, "tz", 5},
                                             {PoseKind::shoulder, "plane_of_elevation", 0},
                                             {PoseKind::shoulder, "elevation", 1},
                                             {PoseKind::shoulder, "axial_rotation", 2},
                                             {PoseKind::shoulder, "tx", 3},
                                             {PoseKind::shoulder, "ty", 4},
                                             {PoseKind::shoulder, "tz", 5},
                                             {PoseKind::steps, "rot_x", 0},
                                             {PoseKind::steps, "rot_y", 1},
                                             {PoseKind::steps, "rot_z", 2},
                                             {PoseKind::steps, "trans_x", 3},
                                             {PoseKind::steps, "trans_y", 4},
                                             {PoseKind::steps, "trans_z", 5}}};

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

// "flexion" from OpenSim's "hip_flexion_r"; other names as they are.
std::string without_opensim(std::string plain) {
  constexpr std::string_view kHip = "hip_";
  if (!plain.starts_with(kHip) || !(plain.ends_with("_r") || plain.ends_with("_l"))) return plain;
  plain = plain.substr(kHip.size(), plain.size() - kHip.size() - 2);
  return plain == "rotation" ? "internal_rotation" : plain;
}

// The entry of a name, of the given kind or of any; null if there is none.
const NumberName* find_name(std::string_view name, std::optional<PoseKind> kind) {
  const std::string plain = without_opensim(plain_name(name));
  const auto at = std::find_if(kNames.begin(), kNames.end(), [&](const NumberName& known) {
    return known.name == plain && known.kind == kind.value_or(known.kind);
  });
  return at == kNames.end() ? nullptr : &*at;
}

[[noreturn]] void refuse_names(const std::vector<std::string>& names) {
  std::string known;
  for (const NumberName& name : kNames)
    if (find_name(name.name, std::nullopt) == &name)
      known += (known.empty() ? "" : ", ") + std::string(name.name);
  for (const std::string& name : names)
    if (find_name(name, std::nullopt) == nullptr)
      throw std::invalid_argument("unknown motion " + in_quotes(name) + "; there are " + known);
  throw std::invalid_argument(in_quotes(names.front()) +
                              " is not of one kind with all of the others; give angles of a hip, angles of a "
                              "shoulder, or rot_x, rot_y, rot_z");
}

using Numbers = std::array<double, 6>;  // three angles, degrees, and a shift, mm

Numbers numbers_of(const PoseList& list, std::size_t row) {
  Numbers numbers{};
  for (std::size_t k = 0; k < list.width(); ++k) {
    if (const PoseColumn& column = list.columns[k]; column.number >= 0)
      numbers[static_cast<std::size_t>(column.number)] = column.sign * list.values[row * list.width() + k];
  }
  return numbers;
}

Eigen::Matrix3d steps_rotation(const Numbers& n) {
  const auto turn = [](double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * kDegree, axis);
  };
  return (turn(n[2], Vec3::UnitZ()) * turn(n[1], Vec3::UnitY()) * turn(n[0], Vec3::UnitX()))
      .toRotationMatrix();
}

// One column of a grid.
struct Axis {
  std::string name;
  double first = 0.0;
  double last = 0.0;
  std::size_t count = 1;

  // Rounded, so that the noise of the division does not show in files.
  double at(std::size_t step) const {
    if (step == 0) return first;
    const double part = static_cast<double>(step) / static_cast<double>(count - 1);
    return std::round((first + part * (last - first)) * 1e9) / 1e9;
  }
};

Axis parse_axis(std::string_view text) {
  const auto refuse = [&](const std::string& why) -> void {
    throw std::invalid_argument(in_quotes(text) + " " + why +
                                "; write NAME=FIRST..LAST/STEP or NAME=NUMBER, as flexion=0..120/1");
  };
  const std::size_t equals = text.find('=');
  if (equals == text.npos) refuse("is no range of a motion");
  Axis axis;
  axis.name = text.substr(0, equals);
  const bool angle = named_poses({axis.name}).columns[0].number < 3;
  const auto number = [&](std::string_view word) {
    const auto value = finite_number(word);
    if (!value || (angle && std::abs(*value) > kLargestAngle))
      refuse("holds " + in_quotes(word) + ", which is no " +
             (angle ? "angle from -180 to 180" : "length in mm"));
    return *value;
  };
  const std::string_view range = text.substr(equals + 1);
  const std::size_t dots = range.find("..");
  axis.first = number(range.substr(0, dots));
  if (dots == range.npos) return axis;
  const std::size_t slash = range.find('/', dots);
  if (slash == range.npos) refuse("has no step");
  axis.last = number(range.substr(dots + 2, slash - dots - 2));
  const auto step = finite_number(range.substr(slash + 1));
  if (!step || !(*step > 0.0)) refuse("has no step above 0");
  const double steps = std::abs(axis.last - axis.first) / *step;
  if (!(steps < kMostPoses)) refuse("has more than ten million steps");
  if (std::abs(steps - std::round(steps)) > 1e-6) refuse("does not meet its last number in whole steps");
  axis.count = static_cast<std::size_t>(std::lround(steps)) + 1;
  return axis;
}

}  // namespace

bool PoseList::tracked(std::size_t row) const {
  for (std::size_t k = 0; k < width(); ++k)
    if (columns[k].number >= 0 && std::isnan(values[row * width() + k])) return false;
  return true;
}

bool PoseList::needs_side() const {
  return kind == PoseKind::shoulder ||
         (kind == PoseKind::hip && std::any_of(columns.begin(), columns.end(), [](const PoseColumn& column) {
            return column.number == 1 || column.number == 2;
          }));
}

bool PoseList::from_scan() const {
  return kind == PoseKind::steps || kind == PoseKind::meshes || kind == PoseKind::centre;
}

bool PoseList::shifts() const {
  return std::any_of(columns.begin(), columns.end(),
                     [](const PoseColumn& column) { return column.number >= 3; });
}

Pose PoseList::pose(std::size_t row, std::optional<Side> side) const {
  if (kind == PoseKind::meshes || kind == PoseKind::centre || kind == PoseKind::joint) {
    const double* m = &values[(row + 1) * width() - 12];
    return {Eigen::Matrix3d{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}},
            Vec3(m[3], m[7], m[11])};
  }
  const Numbers n = numbers_of(*this, row);
  const Vec3 shift(n[3], n[4], n[5]);
  if (kind == PoseKind::hip) return {joint_rotation({n[0], n[1], n[2]}, side), shift};
  if (kind == PoseKind::shoulder) return {shoulder_rotation({n[0], n[1], n[2]}, side.value()), shift};
  const Eigen::Matrix3d turn = steps_rotation(n);
  return {turn, turn * shift};
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name)
    plain += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

PoseList named_poses(const std::vector<std::string>& names) {
  PoseList list;
  for (const PoseKind kind : {PoseKind::steps, PoseKind::shoulder, PoseKind::hip}) {
    if (std::all_of(names.begin(), names.end(),
                    [&](const std::string& name) { return find_name(name, kind) != nullptr; }))
      list.kind = kind;
    else if (kind == PoseKind::hip && list.kind == PoseKind::hip)
      refuse_names(names);
  }
  for (const std::string& name : names) {
    const NumberName& known = *find_name(name, list.kind);
    for (const PoseColumn& other : list.columns)
      if (other.number == known.number)
        throw std::invalid_argument(in_quotes(other.name) + " and " + in_quotes(name) +
                                    " are the same angle or shift; give it once");
    list.columns.push_back({name, known.number, known.sign});
  }
  return list;
}

PoseList parse_pose_grid(std::string_view text) {
  std::vector<Axis> axes;
  std::vector<std::string> names;
  std::size_t poses = 1;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    axes.push_back(parse_axis(text.substr(0, comma)));
    names.push_back(axes.back().name);
    poses *= axes.back().count;
    if (poses > kMostPoses)
      throw std::invalid_argument("more than ten million poses; give longer steps or shorter ranges");
    more = comma != text.npos;
    text.remove_prefix(more ? comma + 1 : 0);
  }
  PoseList list = named_poses(names);
  list.values.reserve(poses * axes.size());
  for (std::size_t pose = 0; pose < poses; ++pose) {
    std::size_t slower = poses;  // number of poses of the columns from this one on
    for (const Axis& axis : axes) {
      const std::size_t faster = slower / axis.count;
      list.values.push_back(axis.at(pose % slower / faster));
      slower = faster;
    }
  }
  return list;
}

}  // namespace impinge
