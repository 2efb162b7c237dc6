// SPDX-License-Identifier: GPL-3.0-or-later
// The ranges of motion that were recorded of the two patients of the thesis (Table 11).
#pragma once

#include <array>
#include <string_view>

#include "joint/anatomy.hpp"

namespace impinge {

struct RecordedMotion {
  std::string_view patient;  // as the presets of joint/hip_presets.hpp
  Side side;
  std::string_view motion;  // one of motion_names()
  double degrees;           // at its end, from standing
};

inline constexpr std::array kRecordedMotions{
    RecordedMotion{"patient_a", Side::right, "abduction", 48.7},
    RecordedMotion{"patient_a", Side::right, "adduction", 26.4},
    RecordedMotion{"patient_a", Side::right, "external_rotation", 39.9},
    RecordedMotion{"patient_a", Side::right, "internal_rotation", 5.6},
    RecordedMotion{"patient_a", Side::right, "extension", 5.2},
    RecordedMotion{"patient_a", Side::right, "flexion", 103.1},
    RecordedMotion{"patient_b", Side::left, "abduction", 30.3},
    RecordedMotion{"patient_b", Side::left, "adduction", 22.7},
    RecordedMotion{"patient_b", Side::left, "external_rotation", 21.0},
    RecordedMotion{"patient_b", Side::left, "internal_rotation", 12.2},
    RecordedMotion{"patient_b", Side::left, "extension", 14.5},
    RecordedMotion{"patient_b", Side::left, "flexion", 115.8}};

}  // namespace impinge
