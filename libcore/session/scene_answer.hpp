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

/// What an answer took.
struct SceneCost {
  std::size_t bytes = 0;     // of tables and whatever stood in for them, not of the answer
  std::size_t entries = 0;   // worked out
  std::size_t look_ups = 0;  // at most: a touch is certain after one gap of 0 or less
};

/// The answer to a scene, and what it took.
struct SceneAnswer {
  std::vector<bool> touches;            // of each pose, for `touch`
  std::optional<SmallestGap> smallest;  // for `first_contact`; none where the surfaces do not meet
  std::vector<PoseGaps> gaps;           // of each pose, for `all_gaps`
  SceneCost cost;                       // in memory and look-ups
  std::string way;                      // that of the plan
  std::vector<LeftOut> left_out;        // by the plan
};

/// Answers by a plan that was made for the same `joint` and `needs`. Vertices of no face have no gap.
SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan);

/// Does the answer hold what the plan assumed: a gap up to the plan's limit, a touch in each pose of
/// plan.touches? A table has no answer next to a rim, so that the vertex in question may have no gap.
bool is_as_planned(const SceneNeeds& needs, const ScenePlan& plan, const SceneAnswer& answer);

/// Plans and answers. If is_as_planned() is false, does so again with all vertices and both scans.
SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given,
                         Omissions omissions = Omissions::all());

}  // namespace impinge
