// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "files/delimited.hpp"
#include "files/finite_number.hpp"
#include "sphere/direction.hpp"

namespace impinge {
namespace {

constexpr std::array kMotionNames{MotionName{"flexion", &Motion::flexion, 1.0},
                                  MotionName{"extension", &Motion::flexion, -1.0},
                                  MotionName{"abduction", &Motion::abduction, 1.0},
                                  MotionName{"adduction", &Motion::abduction, -1.0},
                                  MotionName{"internal_rotation", &Motion::internal_rotation, 1.0},
                                  MotionName{"external_rotation", &Motion::internal_rotation, -1.0}};

double parse_angle(std::string_view name, std::string_view text) {
  const std::optional<double> value = finite_number(text);
  if (!value || std::abs(*value) > kLargestAngle) {
    throw std::invalid_argument("'" + std::string(text) + "' is no angle of " + std::string(name) +
                                "; give degrees from -180 to 180");
  }
  return *value;
}

void require_side(const Motion& motion, std::optional<Side> side) {
  if (side || (motion.abduction == 0.0 && motion.internal_rotation == 0.0)) return;
  throw std::invalid_argument("side: abduction and rotation need to know it; give left or right");
}

using Turn = Eigen::AngleAxisd;

// On the right side the femur abducts towards +x, a negative turn about +y, and its front (+y) turns inwards,
// towards -x, a positive turn about +z.
double mirror(std::optional<Side> side) { return side == Side::left ? -1.0 : 1.0; }

Turn flexed(double degrees) { return {degrees * kDegree, Vec3::UnitX()}; }
Turn abducted(double degrees, std::optional<Side> side) {
  return {-mirror(side) * degrees * kDegree, Vec3::UnitY()};
}
Turn rotated(double degrees, std::optional<Side> side) {
  return {mirror(side) * degrees * kDegree, Vec3::UnitZ()};
}

// Reads "90,0,30"; none where it is not three numbers.
std::optional<Motion> motion_of_numbers(std::string_view text) {
  const auto words = delimited_words(text, ',');
  if (words.size() != 3 || !finite_number(words.front())) return std::nullopt;
  return Motion{parse_angle("flexion", words[0]), parse_angle("abduction", words[1]),
                parse_angle("internal_rotation", words[2])};
}

}  // namespace

std::span<const MotionName> motion_names() { return kMotionNames; }

const MotionName& motion_name(std::string_view name) {
  std::string known;
  for (const MotionName& candidate : kMotionNames) {
    if (candidate.name == name) return candidate;
    known += (known.empty() ? "" : ", ") + std::string(candidate.name);
  }
  throw std::invalid_argument("unknown motion '" + std::string(name) + "'; there are " + known);
}

Motion parse_motion(std::string_view text) {
  if (const auto plain = motion_of_numbers(text)) return *plain;
  Motion motion;
  std::array<bool, 3> given{};
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(','));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    const std::size_t equals = part.find('=');
    if (equals == part.npos) {
      throw std::invalid_argument("'" + std::string(part) +
                                  "' is no motion; write NAME=DEGREES, as flexion=90");
    }
    const MotionName& name = motion_name(part.substr(0, equals));
    bool& seen = given[static_cast<std::size_t>(&name - kMotionNames.data()) / 2];
    if (seen)
      throw std::invalid_argument("the axis of '" + std::string(name.name) +
                                  "' is given twice; give it once");
    seen = true;
    motion.*name.angle = name.sign * parse_angle(name.name, part.substr(equals + 1));
  }
  return motion;
}

Eigen::Matrix3d joint_rotation(const Motion& motion, std::optional<Side> side) {
  require_side(motion, side);
  return (flexed(motion.flexion) * abducted(motion.abduction, side) * rotated(motion.internal_rotation, side))
      .toRotationMatrix();
}

// Elevation turns as abduction does; the two turns about Y are as internal rotation.
Eigen::Matrix3d shoulder_rotation(const ShoulderAngles& angles, Side side) {
  return (rotated(angles.plane_of_elevation, side) * abducted(angles.elevation, side) *
          rotated(angles.axial_rotation, side))
      .toRotationMatrix();
}

JointTurn joint_turn(const Motion& start, const MotionName& growing, std::optional<Side> side) {
  Motion step;
  step.*growing.angle = growing.sign;
  require_side(step, side);
  require_side(start, side);
  const Turn flexion = flexed(start.flexion);
  const Turn abduction = abducted(start.abduction, side);
  const Turn rotation = rotated(start.internal_rotation, side);
  using Matrix = Eigen::Matrix3d;
  if (growing.angle == &Motion::flexion)
    return {Matrix::Identity(), growing.sign * Vec3::UnitX(), (flexion * abduction * rotation).matrix()};
  const double sign = growing.sign * mirror(side);
  if (growing.angle == &Motion::abduction)
    return {flexion.toRotationMatrix(), -sign * Vec3::UnitY(), (abduction * rotation).matrix()};
  return {(flexion * abduction).matrix(), sign * Vec3::UnitZ(), rotation.toRotationMatrix()};
}

double largest_growth(const Motion& start, const MotionName& growing) {
  const double left = kLargestAngle - growing.sign * start.*growing.angle;
  if (left > 0.0) return left;
  throw std::invalid_argument("pose: it leaves no room for " + std::string(growing.name) +
                              " within 180 degrees; begin with a smaller angle");
}

std::vector<Motion> motion_path(const Motion& from, const Motion& to, double step_deg) {
  const double most = std::max({std::abs(to.flexion - from.flexion), std::abs(to.abduction - from.abduction),
                                std::abs(to.internal_rotation - from.internal_rotation)});
  const auto steps = static_cast<std::size_t>(std::ceil(most / step_deg));
  std::vector<Motion> path{from};
  for (std::size_t k = 1; k <= steps; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(steps);
    const auto between = [&](double a, double b) { return k == steps ? b : a + share * (b - a); };
    path.push_back({between(from.flexion, to.flexion), between(from.abduction, to.abduction),
                    between(from.internal_rotation, to.internal_rotation)});
  }
  return path;
}

}  // namespace impinge
