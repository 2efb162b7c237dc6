// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene asks, answered by a plan that leaves out what the question does not need
// (planning/scene_plan.hpp).
#pragma once

#include "scene/measurement.hpp"

namespace impinge {

/// The gaps alone, without their bounds.
Measurement measure_gaps(const Joint& joint, const SceneOptions& options, const Pose& pose);

/// The answer to another question than all_gaps, and the plan that it was found by.
struct QuestionAnswer {
  Pose pose;                      // of the ball, in the centre frame
  SceneAnswer answer;             // to options.question
  std::vector<LeftOut> left_out;  // work and memory that the question did not need
  double milliseconds = 0.0;      // of planning and answering
};
/// Plans and answers options.question in the pose that the options name.
QuestionAnswer answer_question(const Joint& joint, const SceneOptions& options);

}  // namespace impinge
