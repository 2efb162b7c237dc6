// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/motion.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "sphere/direction.hpp"

namespace impinge {
namespace {

struct MotionName {
  std::string_view name;
  double Motion::*angle;
  double sign;
};

constexpr std::array kNames{MotionName{"flexion", &Motion::flexion, 1.0},
                            MotionName{"extension", &Motion::flexion, -1.0},
                            MotionName{"abduction", &Motion::abduction, 1.0},
                            MotionName{"adduction", &Motion::abduction, -1.0},
                            MotionName{"internal_rotation", &Motion::internal_rotation, 1.0},
                            MotionName{"external_rotation", &Motion::internal_rotation, -1.0}};

const MotionName& find_name(std::string_view name) {
  std::string known;
  for (const MotionName& candidate : kNames) {
    if (candidate.name == name) return candidate;
    known += (known.empty() ? "" : ", ") + std::string(candidate.name);
  }
  throw std::invalid_argument("unknown motion '" + std::string(name) + "'; there are " + known);
}

double parse_angle(std::string_view name, std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= 180.0)) {
    throw std::invalid_argument("'" + std::string(text) + "' is no angle of " + std::string(name) +
                                "; give degrees from -180 to 180");
  }
  return value;
}

}  // namespace

Motion parse_motion(std::string_view text) {
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
    const MotionName& name = find_name(part.substr(0, equals));
    bool& seen = given[static_cast<std::size_t>(&name - kNames.data()) / 2];
    if (seen)
      throw std::invalid_argument("the axis of '" + std::string(name.name) +
                                  "' is given twice; give it once");
    seen = true;
    motion.*name.angle = name.sign * parse_angle(name.name, part.substr(equals + 1));
  }
  return motion;
}

Eigen::Matrix3d joint_rotation(const Motion& motion, std::optional<Side> side) {
  if (!side && (motion.abduction != 0.0 || motion.internal_rotation != 0.0)) {
    throw std::invalid_argument("abduction and rotation need to know the side; give left or right");
  }
  // On the right side the femur abducts towards +x, a negative turn about +y, and its front (+y) turns
  // inwards, towards -x, a positive turn about +z.
  const double mirror = side == Side::left ? -1.0 : 1.0;
  using Turn = Eigen::AngleAxisd;
  return (Turn(motion.flexion * kDegree, Vec3::UnitX()) *
          Turn(-mirror * motion.abduction * kDegree, Vec3::UnitY()) *
          Turn(mirror * motion.internal_rotation * kDegree, Vec3::UnitZ()))
      .toRotationMatrix();
}

}  // namespace impinge
