// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/path_choice.hpp"

#include <cmath>

#include "gap/formatted.hpp"

namespace impinge {
namespace {

std::size_t first_that_pays(const PathWork& work) {
  const double gain = kLookPerVertex * static_cast<double>(work.vertices) - kCulledPerPose;
  if (gain <= 0.0) return kNoPoses;
  return static_cast<std::size_t>(std::floor(kCapsPerFace * static_cast<double>(work.faces) / gain)) + 1;
}

}  // namespace

PathChoice choose_path(const PathWork& work) {
  PathChoice choice;
  choice.pays_from = first_that_pays(work);
  choice.culled = work.poses >= choice.pays_from;
  if (choice.pays_from == kNoPoses) {
    choice.reason =
        formatted("each vertex is looked at: %zu are too few for caps of them to pay", work.vertices);
  } else if (choice.culled) {
    choice.reason = formatted(
        "whole caps of vertices are decided at once: that pays from %zu poses on, and there are %zu",
        choice.pays_from, work.poses);
  } else {
    choice.reason =
        formatted("each vertex is looked at: caps of them would pay from %zu poses on, and there %s %zu",
                  choice.pays_from, work.poses == 1 ? "is" : "are", work.poses);
  }
  return choice;
}

}  // namespace impinge
