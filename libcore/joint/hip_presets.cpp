// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/hip_presets.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace impinge {
namespace {

HipParameters cam() {
  HipParameters p;
  p.cam_height = 3.3;
  p.cam_polar = 52.0;
  p.half_opening = 84.0;
  p.lateral_centre_edge = 30.0;
  return p;
}

HipParameters pincer() {
  HipParameters p;
  p.half_opening = 92.0;
  p.lateral_centre_edge = 41.0;
  p.pincer_height = 4.0;
  p.version = 12.0;
  p.joint_space = 4.0;
  return p;
}

HipParameters mixed() {
  HipParameters p = pincer();
  p.cam_height = 2.5;
  p.cam_polar = 50.0;
  p.half_opening = 90.0;
  p.pincer_height = 3.0;
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

HipParameters patient_a() {
  HipParameters p = cam();
  p.side = Side::right;
  return p;
}

HipParameters patient_b() {
  HipParameters p = mixed();
  p.side = Side::left;
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

constexpr auto kNames = [] {
  std::array<std::string_view, kPresets.size()> names;
  for (std::size_t k = 0; k < kPresets.size(); ++k) names[k] = kPresets[k].name;
  return names;
}();

}  // namespace

std::span<const std::string_view> hip_preset_names() { return kNames; }

HipParameters hip_preset(std::string_view name) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset.make();
    known += (known.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw std::invalid_argument("there is no hip '" + std::string(name) + "'; there are " + known);
}

}  // namespace impinge
