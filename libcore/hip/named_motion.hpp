// SPDX-License-Identifier: GPL-3.0-or-later
// The motions whose limits are reported: the six of the joint, and the tests that a clinician does in
// flexion.
#pragma once

#include <span>
#include <string_view>

#include "hip/motion.hpp"

namespace impinge {

/// One angle grows from a start; the others stay as they are there.
struct NamedMotion {
  std::string_view name;     // as options and files have it
  Motion start;              // degrees
  std::string_view growing;  // one of motion_names()
  std::string_view meaning;  // in words
};

/// flexion ... external_rotation from the pose of the scan; internal_rotation_at_45, _70 and _90 (degrees of
/// flexion); external_rotation_at_90; fadir, in which internal rotation grows at 90 of flexion and 15 of
/// adduction; faber, in which external rotation grows at 45 of flexion and 30 of abduction. These angles of
/// fadir and faber are our choice: a clinician takes them as the patient allows.
std::span<const NamedMotion> named_motions();

/// The motion of that name; blanks count as `_`. Throws std::invalid_argument, one line that lists them, for
/// any other.
const NamedMotion& named_motion(std::string_view name);

}  // namespace impinge
