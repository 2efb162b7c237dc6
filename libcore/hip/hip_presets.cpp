// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_presets.hpp"

#include <array>
#include <stdexcept>
#include <string>

namespace impinge {
namespace {

struct Preset {
  std::string_view name;
  HipParameters parameters;
};

constexpr std::array kPresets{
    Preset{"normal", {}},
    // A large cam in a hip with thin cartilage: bone meets bone only where the cam is higher than the joint
    // space.
    Preset{"cam",
           {.cam_height = 4.5,
            .cam_polar = 52.0,
            .cam_clock = 2.5,
            .joint_space = 3.5,
            .half_opening = 85.0,
            .lateral_centre_edge = 31.0}},
    Preset{"pincer",
           {.joint_space = 4.0,
            .version = 12.0,
            .half_opening = 92.0,
            .lateral_centre_edge = 41.0,
            .pincer_height = 4.0}},
    Preset{"mixed",
           {.cam_height = 4.0,
            .cam_half_width = 28.0,
            .cam_clock = 2.5,
            .joint_space = 3.5,
            .version = 16.0,
            .half_opening = 89.0,
            .lateral_centre_edge = 39.0,
            .pincer_height = 2.5}},
    Preset{"dysplastic",
           {.head_radius = 23.0,
            .head_neck_offset = 8.5,
            .neck_shaft_angle = 133.0,
            .femoral_torsion = 25.0,
            .inclination = 60.0,
            .half_opening = 80.0,
            .lateral_centre_edge = 15.0,
            .fossa_depth = 1.5}},
    // An anterosuperior cam far out on the head, under a rim that is nearest to it at 1 to 2 o'clock.
    Preset{"patient_a",
           {.cam_height = 2.8,
            .cam_polar = 75.0,
            .cam_clock = 1.6,
            .head_neck_offset = 9.3,
            .neck_shaft_angle = 126.0,
            .femoral_torsion = 1.0,
            .joint_space = 4.0,
            .version = 9.0,
            .half_opening = 93.0,
            .lateral_centre_edge = 28.0,
            .pincer_height = 1.5,
            .pincer_clock = 1.7,
            .pincer_half_width = 0.7,
            .shift_lateral = 0.3,
            .shift_anterior = -1.35}},
    // A broad cam, a deep socket, and a prominent rim at 7 o'clock, to which the neck comes near in
    // adduction.
    Preset{"patient_b",
           {.side = Side::left,
            .cam_height = 2.5,
            .cam_half_width = 38.0,
            .cam_polar = 75.0,
            .cam_clock = 1.9,
            .head_neck_offset = 7.0,
            .neck_shaft_angle = 121.0,
            .femoral_torsion = 9.5,
            .joint_space = 3.3,
            .version = 12.0,
            .half_opening = 96.0,
            .lateral_centre_edge = 28.0,
            .pincer_height = 6.5,
            .pincer_clock = 6.75,
            .pincer_half_width = 1.25,
            .shift_lateral = 1.1,
            .shift_anterior = -0.5,
            .shift_superior = 0.2}}};

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
    if (preset.name == name) return preset.parameters;
    known += (known.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw std::invalid_argument("there is no hip '" + std::string(name) + "'; there are " + known);
}

}  // namespace impinge
