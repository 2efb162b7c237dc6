// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace impinge {
namespace {

using H = HipParameters;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

void require_in_range(const HipParameter& parameter, double value) {
  if (value >= parameter.least && value <= parameter.most) return;
  throw std::invalid_argument("parameter " + std::string(parameter.name) + " = " + number(value) +
                              " is outside of what a hip can have; give " + number(parameter.least) + " to " +
                              number(parameter.most) + " " + std::string(parameter.unit));
}

const HipParameter& find_parameter(std::string_view name) {
  std::string known = "side";
  for (const HipParameter& candidate : hip_parameter_list()) {
    if (candidate.name == name) return candidate;
    known += ", " + std::string(candidate.name);
  }
  throw std::invalid_argument("a hip has no parameter '" + std::string(name) + "'; there are " + known);
}

}  // namespace

const std::array<HipParameter, kHipParameters>& hip_parameter_list() {
  static constexpr std::array<HipParameter, kHipParameters> kList{{
      {"head_radius", "mm", &H::head_radius, 5.0, 60.0},
      {"head_axis_ratio", "1", &H::head_axis_ratio, 0.8, 1.2},
      {"conchoid_a", "mm", &H::conchoid_a, 0.0, 60.0},
      {"conchoid_b", "mm", &H::conchoid_b, 0.0, 60.0},
      {"cam_height", "mm", &H::cam_height, 0.0, 15.0},
      {"cam_half_width", "deg", &H::cam_half_width, 5.0, 60.0},
      {"cam_polar", "deg", &H::cam_polar, 20.0, 120.0},
      {"cam_clock", "h", &H::cam_clock, 0.0, 12.0},
      {"head_neck_offset", "mm", &H::head_neck_offset, 0.0, 50.0},
      {"neck_fillet", "mm", &H::neck_fillet, 0.0, 15.0},
      {"neck_length", "mm", &H::neck_length, 10.0, 150.0},
      {"neck_shaft_angle", "deg", &H::neck_shaft_angle, 95.0, 160.0},
      {"femoral_torsion", "deg", &H::femoral_torsion, -45.0, 60.0},
      {"shaft_length", "mm", &H::shaft_length, 0.0, 200.0},
      {"shaft_radius", "mm", &H::shaft_radius, 3.0, 40.0},
      {"joint_space", "mm", &H::joint_space, 0.05, 15.0},
      {"inclination", "deg", &H::inclination, 15.0, 85.0},
      {"version", "deg", &H::version, -45.0, 60.0},
      {"half_opening", "deg", &H::half_opening, 45.0, 120.0},
      {"lateral_centre_edge", "deg", &H::lateral_centre_edge, -20.0, 70.0},
      {"pincer_height", "mm", &H::pincer_height, 0.0, 15.0},
      {"pincer_clock", "h", &H::pincer_clock, 0.0, 12.0},
      {"pincer_half_width", "h", &H::pincer_half_width, 0.5, 4.0},
      {"fossa_depth", "mm", &H::fossa_depth, 0.0, 8.0},
      {"fossa_half_width", "deg", &H::fossa_half_width, 5.0, 45.0},
      {"fossa_polar", "deg", &H::fossa_polar, 0.0, 60.0},
      {"shift_lateral", "mm", &H::shift_lateral, -5.0, 5.0},
      {"shift_anterior", "mm", &H::shift_anterior, -5.0, 5.0},
      {"shift_superior", "mm", &H::shift_superior, -5.0, 5.0},
      {"wall_thickness", "mm", &H::wall_thickness, 0.0, 20.0},
  }};
  return kList;
}

void set_hip_parameter(HipParameters& parameters, std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos) {
    throw std::invalid_argument("'" + std::string(text) +
                                "' sets no parameter; write NAME=VALUE, as cam_height=3");
  }
  const std::string_view name = text.substr(0, equals);
  const std::string_view value = text.substr(equals + 1);
  if (name == "side") {
    parameters.side = parse_side(value);
    return;
  }
  const HipParameter& parameter = find_parameter(name);
  double x = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), x);
  if (error != std::errc() || end != value.data() + value.size()) {
    throw std::invalid_argument("'" + std::string(value) + "' is no value of " + std::string(name) +
                                "; give a number in " + std::string(parameter.unit));
  }
  require_in_range(parameter, x);
  parameters.*parameter.value = x;
}

void require_in_range(const HipParameters& parameters) {
  for (const HipParameter& parameter : hip_parameter_list()) {
    require_in_range(parameter, parameters.*parameter.value);
  }
}

}  // namespace impinge
