// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps of all vertices to the faces in a pose, and how far those of a method are off.
#pragma once

#include "10_error_against_time/contact.hpp"
#include "contact/culled_joint.hpp"

namespace impinge::lab {

/// Does the exact test of every vertex find one that is impinged?
bool any_impinged(const CulledJoint& joint, const Pose& pose);

/// Gaps to the faces, mm; NaN where the other surface is not met.
struct ExactGaps {
  std::vector<double> ball;
  std::vector<double> socket;
};
ExactGaps exact_gaps(const CulledJoint& joint, const Pose& pose);

/// Largest error of a gap, mm; a vertex without an answer has none. std::runtime_error where it is larger
/// than a table allows.
double gap_error(const MadeContact& made, const ExactGaps& exact, const Pose& pose);

}  // namespace impinge::lab
