// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "files/finite_number.hpp"

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
      {"head_radius", "mm", &H::head_radius, 5.0, 60.0,
       "of the head, square to the neck; cartilage of five heads has 23 to 26"},
      {"head_axis_ratio", "1", &H::head_axis_ratio, 0.8, 1.2,
       "half axis along the neck to the head's radius: 1 is a sphere"},
      {"conchoid_a", "mm", &H::conchoid_a, 0.0, 60.0,
       "with b, both above 0: the head is Menschik's conchoid a + b cos(phi) about the neck"},
      {"conchoid_b", "mm", &H::conchoid_b, 0.0, 60.0, "of the conchoid, below a"},
      {"cam_height", "mm", &H::cam_height, 0.0, 15.0,
       "of the bump between head and neck, at its top; 0 is none"},
      {"cam_half_width", "deg", &H::cam_half_width, 5.0, 60.0,
       "from the top of the bump to its foot, as seen from the centre"},
      {"cam_polar", "deg", &H::cam_polar, 20.0, 120.0, "of the top of the bump, from the axis of the neck"},
      {"cam_clock", "h", &H::cam_clock, 0.0, 12.0,
       "of the top of the bump, about the neck: 12 is superior, 3 anterior"},
      {"head_neck_offset", "mm", &H::head_neck_offset, 0.0, 50.0,
       "radius of the head minus that of the neck"},
      {"neck_fillet", "mm", &H::neck_fillet, 0.0, 15.0, "reach of the rounding between head and neck"},
      {"neck_length", "mm", &H::neck_length, 10.0, 150.0,
       "from the centre of the head to the axis of the shaft"},
      {"neck_shaft_angle", "deg", &H::neck_shaft_angle, 95.0, 160.0, "CCD angle, at the medial side"},
      {"femoral_torsion", "deg", &H::femoral_torsion, -45.0, 60.0,
       "anteversion of the neck from the transverse axis, in the plane square to the shaft"},
      {"shaft_length", "mm", &H::shaft_length, 0.0, 200.0,
       "of the stump of the shaft; 0 ends the neck in a dome"},
      {"shaft_radius", "mm", &H::shaft_radius, 3.0, 40.0, "of the stump of the shaft"},
      {"greater_trochanter_width", "mm", &H::greater_trochanter_width, 0.0, 60.0,
       "of the greater trochanter, from front to back; 0 leaves it out"},
      {"greater_trochanter_tip", "mm", &H::greater_trochanter_tip, -40.0, 40.0,
       "of its tip, above the centre of the head along the shaft"},
      {"greater_trochanter_offset", "mm", &H::greater_trochanter_offset, 20.0, 100.0,
       "from the centre of the head to its tip, square to the shaft"},
      {"greater_trochanter_behind", "mm", &H::greater_trochanter_behind, -20.0, 30.0,
       "of its tip, behind the plane of neck and shaft"},
      {"lesser_trochanter_height", "mm", &H::lesser_trochanter_height, 0.0, 20.0,
       "of the lesser trochanter, over the shaft; 0 leaves it out"},
      {"lesser_trochanter_angle", "deg", &H::lesser_trochanter_angle, -45.0, 90.0,
       "of the lesser trochanter, behind the medial side"},
      {"joint_space", "mm", &H::joint_space, 0.05, 15.0,
       "radius of the socket minus that of the head, bone to bone"},
      {"inclination", "deg", &H::inclination, 15.0, 85.0,
       "of the socket's axis from straight down, as seen from the front"},
      {"version", "deg", &H::version, -45.0, 60.0,
       "of the socket's axis from lateral to anterior, as seen from above"},
      {"half_opening", "deg", &H::half_opening, 45.0, 120.0,
       "from the pole of the socket to its rim; 90 is half a sphere"},
      {"lateral_centre_edge", "deg", &H::lateral_centre_edge, -20.0, 70.0,
       "LCE angle: from the vertical to the lateral rim, in the coronal plane"},
      {"pincer_height", "mm", &H::pincer_height, 0.0, 15.0,
       "of the additional rim at its highest; 0 is none"},
      {"pincer_clock", "h", &H::pincer_clock, 0.0, 12.0,
       "of the middle of the additional rim: 12 is superior, 3 anterior"},
      {"pincer_half_width", "h", &H::pincer_half_width, 0.5, 4.0,
       "from the middle of the additional rim to its end"},
      {"aiis_height", "mm", &H::aiis_height, 0.0, 30.0,
       "of the anterior inferior iliac spine, over the plane of the rim; 0 leaves it out"},
      {"aiis_distance", "mm", &H::aiis_distance, 0.0, 40.0,
       "of its middle from the rim, outwards; 11 reaches the rim"},
      {"aiis_clock", "h", &H::aiis_clock, 0.0, 12.0, "of its middle about the socket's axis: 12 is superior"},
      {"fossa_depth", "mm", &H::fossa_depth, 0.0, 8.0, "of the pit in the floor of the socket"},
      {"fossa_half_width", "deg", &H::fossa_half_width, 5.0, 45.0, "of the pit, as seen from the centre"},
      {"fossa_polar", "deg", &H::fossa_polar, 0.0, 60.0,
       "of the pit's middle, from the pole of the socket towards 6 o'clock"},
      {"shift_lateral", "mm", &H::shift_lateral, -5.0, 5.0,
       "of the socket's centre from that of the head, outwards"},
      {"shift_anterior", "mm", &H::shift_anterior, -5.0, 5.0,
       "of the socket's centre from that of the head, forwards"},
      {"shift_superior", "mm", &H::shift_superior, -5.0, 5.0,
       "of the socket's centre from that of the head, upwards"},
      {"wall_thickness", "mm", &H::wall_thickness, 0.0, 20.0,
       "of the socket's wall; 0 is the inner surface alone"},
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
  const std::optional<double> x = finite_number(value);
  if (!x) {
    throw std::invalid_argument("'" + std::string(value) + "' is no value of " + std::string(name) +
                                "; give a number in " + std::string(parameter.unit));
  }
  require_in_range(parameter, *x);
  parameters.*parameter.value = *x;
}

void require_in_range(const HipParameters& parameters) {
  for (const HipParameter& parameter : hip_parameter_list()) {
    require_in_range(parameter, parameters.*parameter.value);
  }
}

}  // namespace impinge
