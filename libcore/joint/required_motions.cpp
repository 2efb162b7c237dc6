// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/required_motions.hpp"

#include <algorithm>
#include <stdexcept>

namespace impinge {

void check_required(std::span<const Motion> require) {
  const auto still = [](const Motion& motion) {
    return motion.flexion == 0.0 && motion.abduction == 0.0 && motion.internal_rotation == 0.0;
  };
  if (require.empty() || std::any_of(require.begin(), require.end(), still))
    throw std::invalid_argument(
        "require: a required motion turns something; give one, as flexion=90,internal_rotation=30");
}

}  // namespace impinge
