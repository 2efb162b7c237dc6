// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that are required of a joint after a change, by a cut (joint/resect.hpp) or by another orientation
// of its socket (joint/orient.hpp).
#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

#include "hip/motion.hpp"

namespace impinge {

/// Shown on the screen with every such answer.
inline constexpr std::string_view kNoGuide =
    "Research software, not a medical device: nothing in this may guide the treatment of a patient.";

/// The help for `require` in a request (change/required_motion.hpp).
inline constexpr std::string_view kRequireText =
    "motion that has to be free, such as flexion=90,internal_rotation=30: the joint turns from the pose of "
    "the scan by flexion, then abduction, then rotation; more than one may be given";

/// Throws std::invalid_argument, one line, if there is no motion, or one that moves nothing.
inline void check_required(std::span<const Motion> require) {
  const auto still = [](const Motion& motion) { return is_rest(motion); };
  if (require.empty() || std::any_of(require.begin(), require.end(), still))
    throw std::invalid_argument(
        "require: a required motion turns something; give one, as flexion=90,internal_rotation=30");
}

}  // namespace impinge
