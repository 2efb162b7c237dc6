// SPDX-License-Identifier: GPL-3.0-or-later
// A plan (scene_plan.hpp) while it is made, with its inputs, and the two steps that make it.
#pragma once

#include <cstdint>

#include "session/scene_plan.hpp"

namespace impinge {

/// What plan_scene() was given, and how far the plan is.
struct PlanDraft {
  const BallSocketPair& joint;  // centre frames, mm
  const SceneNeeds& needs;      // what is asked
  const AnyScheme& given;       // the table that everything would be done with
  Omissions omissions;          // what may be left out
  ScenePlan plan;               // so far
};

/// Step 1: leaves out the vertices, and perhaps the second scan, that cannot change the answer. Sets the
/// plan's limit.
void choose_vertices(PlanDraft& draft);

/// Step 2: chooses the table, if an accuracy is asked for, and for each scan the entries that its look-ups
/// read.
void choose_entries(PlanDraft& draft);

/// Gives the scan an index of the faces near each direction, with a margin of `margin` radians or more.
void index_faces(const BallSocketPair& joint, double margin, ScanPlan& scan);

/// Calls visit(x) for each look-up of the scan, so far as it is planned, in the order of poses and vertices;
/// x is in the frame of the other surface.
template <class Visit>
void for_each_look_up(const PlanDraft& draft, const ScanPlan& scan, Visit&& visit) {
  const TriangleMesh& mesh = mesh_of(draft.joint, scan.scanned);
  for (std::size_t p = 0; p < draft.needs.poses.size(); ++p) {
    const Pose& pose = draft.needs.poses[p];
    if (scan.vertices) {
      for (const std::uint32_t v : (*scan.vertices)[p]) visit(to_other(scan.scanned, pose, mesh.vertices[v]));
    } else {
      for (const Vec3& v : mesh.vertices) visit(to_other(scan.scanned, pose, v));
    }
  }
}

}  // namespace impinge
