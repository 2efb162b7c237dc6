// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/anatomy.hpp"

#include <stdexcept>
#include <string>

#include <Eigen/LU>

namespace impinge {
namespace {

constexpr std::string_view kForward = "RAS";
constexpr std::string_view kBackward = "LPI";

[[noreturn]] void refuse(std::string_view code, const std::string& reason) {
  throw std::invalid_argument(
      "axis code '" + std::string(code) + "' " + reason +
      "; name where +x, +y and +z point with one letter each of R/L, A/P and S/I, as RAS or LPS");
}

}  // namespace

Side parse_side(std::string_view text) {
  if (text == "left") return Side::left;
  if (text == "right") return Side::right;
  throw std::invalid_argument("side '" + std::string(text) + "' is neither left nor right");
}

Eigen::Matrix3d input_to_joint(std::string_view axis_code) {
  if (axis_code.size() != 3) refuse(axis_code, "does not have three letters");
  Eigen::Matrix3d map = Eigen::Matrix3d::Zero();
  for (Eigen::Index column = 0; column < 3; ++column) {
    const char letter = axis_code[static_cast<std::size_t>(column)];
    const std::size_t forward = kForward.find(letter);
    const std::size_t backward = kBackward.find(letter);
    if (forward == kForward.npos && backward == kBackward.npos) refuse(axis_code, "has an unknown letter");
    const bool along = forward != kForward.npos;
    map(static_cast<Eigen::Index>(along ? forward : backward), column) = along ? 1.0 : -1.0;
  }
  const double determinant = map.determinant();
  if (determinant == 0.0) refuse(axis_code, "names one direction twice");
  if (determinant < 0.0) refuse(axis_code, "is left-handed and would mirror the patient");
  return map;
}

}  // namespace impinge
