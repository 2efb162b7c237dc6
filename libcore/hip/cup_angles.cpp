// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/cup_angles.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace impinge {
namespace {

double lateral(Side side) { return side == Side::left ? -1.0 : 1.0; }

Eigen::Matrix3d turn_about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix();
}

}  // namespace

CupAngles cup_angles(const Vec3& opening, Side side) {
  return {std::atan2(lateral(side) * opening.x(), -opening.z()) / kDegree,
          std::asin(std::clamp(opening.y(), -1.0, 1.0)) / kDegree};
}

// A turn about +y takes down, -z, towards -x.
Eigen::Matrix3d cup_rotation(const CupAngles& angles, Side side) {
  return turn_about(Vec3::UnitY(), -lateral(side) * angles.inclination_deg) *
         turn_about(Vec3::UnitX(), angles.anteversion_deg);
}

Eigen::Matrix3d pelvic_tilt(double backwards_deg) { return turn_about(Vec3::UnitX(), backwards_deg); }

}  // namespace impinge
