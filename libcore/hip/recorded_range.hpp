// SPDX-License-Identifier: GPL-3.0-or-later
// The range of motion that was recorded from the two patients of the thesis (Table 11), by markers on the
// skin.
#pragma once

#include <array>
#include <string_view>

namespace impinge {

/// Largest angles in degrees; the motions are those that parse_motion() knows, the order is that of Tables 12
/// and 13.
struct RecordedRange {
  std::string_view motion;  // one of motion_names()
  double patient_a = 0.0;   // right hip
  double patient_b = 0.0;   // left hip
};

/// Table 11.
inline constexpr std::array kRecordedRanges{
    RecordedRange{"abduction", 48.7, 30.3},        RecordedRange{"adduction", 26.4, 22.7},
    RecordedRange{"internal_rotation", 5.6, 12.2}, RecordedRange{"external_rotation", 39.9, 21.0},
    RecordedRange{"extension", 5.2, 14.5},         RecordedRange{"flexion", 103.1, 115.8}};

}  // namespace impinge
