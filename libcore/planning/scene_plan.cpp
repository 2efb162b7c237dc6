// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/scene_plan.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "gap/formatted.hpp"
#include "planning/entry_choice.hpp"
#include "planning/vertex_choice.hpp"

namespace impinge {
namespace {

void check(const SceneNeeds& needs) {
  if (needs.poses.empty() || !(needs.ball || needs.socket)) {
    throw std::invalid_argument("a scene without poses or without scans asks nothing: give one of each");
  }
  if (needs.accuracy_mm && !(*needs.accuracy_mm > 0.0)) {
    throw std::invalid_argument("an accuracy of " + formatted("%g", *needs.accuracy_mm) +
                                " mm cannot be kept: give one above 0");
  }
}

bool equal(const Pose& a, const Pose& b) {
  return a.rotation == b.rotation && a.translation == b.translation;
}

void choose_poses(PlanDraft& draft) {
  const std::vector<Pose>& poses = draft.needs.poses;
  ScenePlan& plan = draft.plan;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    const auto seen = std::ranges::find_if(plan.poses, [&](std::size_t q) {
      return draft.omissions.has(Omission::equal_poses) && equal(poses[p], poses[q]);
    });
    plan.same_as.push_back(static_cast<std::size_t>(seen - plan.poses.begin()));
    if (seen == plan.poses.end()) plan.poses.push_back(p);
  }
  const std::size_t again = poses.size() - plan.poses.size();
  if (again == 0) return;
  plan.left_out.push_back(
      {Omission::equal_poses, formatted("%zu of %zu poses came before", again, poses.size()), 0.0});
}

void choose_scans(PlanDraft& draft) {
  auto& [ball, socket] = draft.plan.scans;
  ball.scanned = Surface::ball;
  ball.wanted = draft.needs.ball;
  socket.scanned = Surface::socket;
  socket.wanted = draft.needs.socket;
}

}  // namespace

std::size_t ScenePlan::bytes() const {
  std::size_t total = caps_bytes;
  for (const ScanPlan& scan : scans) {
    if (scan.faces) total += scan.faces->bytes();
    if (!scan.vertices) continue;
    for (const auto& chosen : *scan.vertices) total += chosen.capacity() * sizeof(std::uint32_t);
  }
  return total;
}

ScenePlan plan_scene(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given,
                     Omissions omissions) {
  check(needs);
  PlanDraft draft{joint, needs, given, omissions, ScenePlan(given)};
  choose_poses(draft);
  choose_scans(draft);
  choose_vertices(draft);
  choose_entries(draft);
  return std::move(draft.plan);
}

// exp(t) - 1 <= t + t^2 for t in [0, 1].
bool keeps_accuracy(const TableChoice& table, double storage_bound, const NearFaces::Near& near) {
  const double t = near.slope * table.scheme.stencil_radius();
  return t <= 1.0 && near.range.high * t * (1.0 + t) + storage_bound <= *table.accuracy_mm;
}

}  // namespace impinge
