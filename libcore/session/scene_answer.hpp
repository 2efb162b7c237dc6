// SPDX-License-Identifier: GPL-3.0-or-later
// Answering what a scene asks, by a plan.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "session/scene_plan.hpp"

namespace impinge {

/// Gaps of all vertices in one pose, mm; NaN where the other surface is not met.
struct PoseGaps {
  std::vector<double> ball;    // by vertex of the ball; empty where it is not scanned
  std::vector<double> socket;  // by vertex of the socket, the same
};

/// The first of the smallest gaps, in the order of scans, poses and vertices.
struct SmallestGap {
  double gap_mm = 0.0;              // of the vertex
  Surface scanned = Surface::ball;  // whose vertex it is
  std::size_t pose = 0;             // of the needs
  std::size_t vertex = 0;           // place among the vertices of its mesh
  bool operator==(const SmallestGap&) const = default;
};

/// What it took.
struct SceneCost {
  std::size_t bytes = 0;     // of tables and whatever stood in for them, not of the answer
  std::size_t entries = 0;   // worked out
  std::size_t look_ups = 0;  // at most: a touch is certain after one gap of 0 or less
};

/// What was asked, and what it took.
struct SceneAnswer {
  std::vector<bool> touches;            // of each pose, for `touch`
  std::optional<SmallestGap> smallest;  // for `first_contact`; none where the surfaces do not meet
  std::vector<PoseGaps> gaps;           // of each pose, for `all_gaps`
  SceneCost cost;                       // in memory and look-ups
  std::string way;                      // that of the plan
  std::vector<LeftOut> left_out;        // by the plan
};

/// Vertices of no face belong to no surface and have no gap. `joint` and `needs` are those of the plan.
SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan);

/// Has the answer what the plan took for proven? A gap that does not exceed the limit, a touch where it
/// promised one: a rim may have taken the answer of the vertex away that has it.
bool is_as_planned(const SceneNeeds& needs, const ScenePlan& plan, const SceneAnswer& answer);

/// Plans and answers; anew and without bounds where a plan could not keep what it promised.
SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given,
                         Omissions omissions = Omissions::all());

}  // namespace impinge
