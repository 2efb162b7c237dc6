// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_presets.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace impinge {
namespace {

// A large cam in a hip with thin cartilage: bone meets bone only where the cam is higher than the joint
// space.
HipParameters cam() {
  HipParameters p;
  p.cam_height = 4.5;
  p.cam_polar = 52.0;
  p.cam_clock = 2.5;
  p.joint_space = 3.5;
  p.half_opening = 85.0;
  p.lateral_centre_edge = 31.0;
  return p;
}

HipParameters pincer() {
  HipParameters p;
  p.joint_space = 4.0;
  p.version = 12.0;
  p.half_opening = 92.0;
  p.lateral_centre_edge = 41.0;
  p.pincer_height = 4.0;
  return p;
}

HipParameters mixed() {
  HipParameters p = cam();
  p.cam_height = 4.0;
  p.cam_half_width = 28.0;
  p.cam_polar = 50.0;
  p.version = 16.0;
  p.half_opening = 89.0;
  p.lateral_centre_edge = 39.0;
  p.pincer_height = 2.5;
  return p;
}

HipParameters dysplastic() {
  HipParameters p;
  p.head_radius = 23.0;
  p.head_neck_offset = 8.5;
  p.half_opening = 80.0;
  p.inclination = 60.0;
  p.lateral_centre_edge = 15.0;
  p.neck_shaft_angle = 133.0;
  p.femoral_torsion = 25.0;
  p.fossa_depth = 1.5;
  return p;
}

// An anterosuperior cam far out on the head, under a rim that is nearest to it at 1 to 2 o'clock.
HipParameters patient_a() {
  HipParameters p;
  p.side = Side::right;
  p.cam_height = 2.8;
  p.cam_polar = 75.0;
  p.cam_clock = 1.6;
  p.head_neck_offset = 9.3;
  p.neck_shaft_angle = 126.0;
  p.femoral_torsion = 1.0;
  p.joint_space = 4.0;
  p.version = 9.0;
  p.half_opening = 93.0;
  p.lateral_centre_edge = 28.0;
  p.pincer_height = 1.5;
  p.pincer_clock = 1.7;
  p.pincer_half_width = 0.7;
  p.shift_lateral = 0.3;
  p.shift_anterior = -1.35;
  return p;
}

// A broad cam, a deep socket, and a prominent rim at 7 o'clock, which the neck comes near to in adduction.
HipParameters patient_b() {
  HipParameters p;
  p.side = Side::left;
  p.cam_height = 2.5;
  p.cam_half_width = 38.0;
  p.cam_polar = 75.0;
  p.cam_clock = 1.9;
  p.head_neck_offset = 7.0;
  p.neck_shaft_angle = 121.0;
  p.femoral_torsion = 9.5;
  p.joint_space = 3.3;
  p.version = 12.0;
  p.half_opening = 96.0;
  p.lateral_centre_edge = 28.0;
  p.pincer_height = 6.5;
  p.pincer_clock = 6.75;
  p.pincer_half_width = 1.25;
  p.shift_lateral = 1.1;
  p.shift_anterior = -0.5;
  p.shift_superior = 0.2;
  return p;
}

struct Preset {
  std::string_view name;
  HipParameters (*make)();
};

constexpr std::array kPresets{Preset{"normal", [] { return HipParameters{}; }},
                              Preset{"cam", cam},
                              Preset{"pincer", pincer},
                              Preset{"mixed", mixed},
                              Preset{"dysplastic", dysplastic},
                              Preset{"patient_a", patient_a},
                              Preset{"patient_b", patient_b}};

constexpr auto kPresetNames = [] {
  std::array<std::string_view, kPresets.size()> names;
  for (std::size_t k = 0; k < kPresets.size(); ++k) names[k] = kPresets[k].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> hip_preset_names() { return kPresetNames; }

HipParameters hip_preset(std::string_view name) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset.make();
    known += (known.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw std::invalid_argument("there is no hip '" + std::string(name) + "'; there are " + known);
}

}  // namespace impinge
