// SPDX-License-Identifier: GPL-3.0-or-later
// Works out what is asked of a joint in one pose.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "joint/certificate.hpp"
#include "joint/needed_work.hpp"
#include "joint/pose_answer.hpp"
#include "joint/pose_question.hpp"
#include "joint/touch.hpp"

namespace impinge {

/// All gaps, and what else was asked for. Gaps, and all that rests on them, are those between the main
/// surfaces: vertices of parts have none. Distances are to any bone of the other side.
struct Measurement : PoseAnswer {
  double precision_deg = 0.0;                 // of both tables; 0 without
  std::size_t entries = 0;                    // of each table
  std::size_t bytes = 0;                      // of both tables
  double fill_ms = 0.0;                       // both tables
  double bound_ms = 0.0;                      // the bounds of all gaps
  double distance_ms = 0.0;                   // all Euclidean distances
  std::optional<PoseVerdicts> proven;         // by the bounds, where they are asked for
  std::optional<BodyPairs::Verdict> contact;  // of the bones, where verdicts are asked for
  std::optional<Certificate> certificate;     // of radial overlap, likewise
  std::optional<NearestPartDocument> part;    // if the joint has parts
  std::string way;                            // how the gaps were found and why so, one clause
  std::vector<LeftOut> left_out;              // work and memory that the question did not need
};

/// Finds all gaps in a pose: on the faces (gap/measured_gap.hpp), or with precision_deg by a table in double
/// of each surface, all of which is worked out only for bounds and verdicts (joint/needed_work.hpp).
///
/// std::runtime_error, one line, if the tables do not fit in memory (with the bytes that they would take), or
/// max_error_mm is below what rounding leaves.
Measurement measure(Session& session, const PoseQuestion& asked);

}  // namespace impinge
