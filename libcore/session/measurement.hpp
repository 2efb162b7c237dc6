// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a joint in one pose, worked out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "session/certificate.hpp"
#include "session/pose_answer.hpp"
#include "session/pose_question.hpp"
#include "session/scene_answer.hpp"

namespace impinge {

/// Bone beside a joint in a pose: the two bodies that are nearest to each other, of which one at least is a
/// part.
struct NearestPart {
  double distance_mm = 0.0;      // of their surfaces; 0 in contact
  bool touch = false;            // exact
  std::string ball_part = {};    // empty: the ball's main surface
  std::string socket_part = {};  // the same of the socket
};

/// All gaps, and what else was asked for. Gaps, and all that rests on them, are those between the main
/// surfaces: vertices of parts have none. Distances are to any bone of the other side.
struct Measurement : PoseAnswer {
  double precision_deg = 0.0;              // of both tables; 0 without, and with an accuracy
  std::size_t entries = 0;                 // of each table; worked out in both, with an accuracy
  std::size_t bytes = 0;                   // of both tables
  double fill_ms = 0.0;                    // both tables
  double bound_ms = 0.0;                   // the bounds of all gaps
  double distance_ms = 0.0;                // all Euclidean distances
  std::optional<PoseVerdicts> proven;      // by the bounds, where they are asked for
  std::optional<Certificate> certificate;  // exact verdicts on vertices and surfaces
  std::optional<NearestPart> part;         // none of a joint without parts
  std::string way;                         // how the gaps were found, and why so, in one clause
  std::vector<LeftOut> left_out;           // work and memory that the question did not need
};

/// Measures each gap, with its bound, on the faces (gap/measured_gap.hpp). Where a precision is asked for, it
/// fills a table in double for each surface and scans both; where neither bounds nor verdicts are asked for,
/// only what the gaps need is done (session/scene_plan.hpp). With an accuracy, gaps that no table is proven
/// to keep that accurate are measured on the faces, and bounds, where they are asked for, are those of
/// holding each gap against the faces.
///
/// std::runtime_error, one line, if the tables do not fit in memory (with the bytes that they would take) or
/// the accuracy is below what rounding leaves.
Measurement measure(Session& session, const PoseQuestion& asked);

/// The answer to another question than all_gaps, and the plan that it was found by.
struct QuestionAnswer {
  Pose pose;                  // of the ball, in the centre frame
  SceneAnswer answer;         // to the question
  double milliseconds = 0.0;  // of planning and answering
};
/// Plans and answers the question in the pose that the motion names. With parts the smallest gap is that
/// between the main surfaces; std::runtime_error for touch of vertices alone.
QuestionAnswer answer_question(SessionJoint& joint, const PoseQuestion& asked);

}  // namespace impinge
