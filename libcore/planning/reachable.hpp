// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices may matter in which pose, by what NearFaces proves of their surroundings.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "planning/scene_plan.hpp"

namespace impinge {

/// A vertex that meets the other surface.
struct Reachable {
  std::uint32_t vertex;  // place among those of its mesh
  double low;            // mm: its gap is no smaller
};

/// What is looked at.
struct ReachTask {
  const BallSocketPair& joint;            // centre frames, mm
  const SceneNeeds& needs;                // what is asked
  const std::vector<std::size_t>& poses;  // of the needs, those that are looked at
  std::array<ScanPlan, 2>& scans;         // those that are wanted have their faces
  bool culled;                            // by whole caps of vertices, and not each vertex
};

/// What was found. Vertices that are not listed have no gap of limit_mm or less; where all gaps are asked
/// for, none at all.
struct Reach {
  std::array<std::vector<std::vector<Reachable>>, 2> found;  // of ball and socket: of each pose
  /// Where a vertex is proven to touch, away from any rim, it is the only one that is listed of the pose.
  std::vector<bool> touches;
  double limit_mm = 0.0;  // of the question
  std::size_t bytes = 0;  // of the caps, which are gone afterwards
};

/// Finds them: of the vertices of faces, in the order of the mesh. With caps the vertices of a node are left
/// out together where its bound is above the limit (contact/gap_bounds.hpp), by limits with a margin of the
/// stencil radius, so that they hold for tables too.
Reach find_reach(const ReachTask& task, double stencil_radius);

}  // namespace impinge
