// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables prove about a pose, vertex by vertex: the gaps of both scans, each with the bound of the
// cell that it reads.
#pragma once

#include <cstddef>

#include "gap/measured_gap.hpp"
#include "pose_answer.hpp"

namespace impinge {

struct PoseVerdicts {
  VerdictCount vertices;      // of those that have a gap, on both surfaces
  std::size_t unbounded = 0;  // of the undecided ones, those about which nothing is proven
  double largest_mm = 0.0;    // the largest bound of the others
  double median_mm = 0.0;     // and their median, the upper one of two
  SmallestBetween smallest;   // of all that have a gap
};

// The verdicts of scene/certificate.hpp before its exact look. Bounds the tables when that has not been done.
PoseVerdicts answer_verdicts(Session& session, const PoseRequest& request);

}  // namespace impinge
