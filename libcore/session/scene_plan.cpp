// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_plan.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "files/formatted.hpp"
#include "session/plan_draft.hpp"

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

}  // namespace

std::size_t ScenePlan::bytes() const {
  std::size_t total = 0;
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
  auto& [ball, socket] = draft.plan.scans;
  ball.wanted = needs.ball;
  socket.scanned = Surface::socket;
  socket.wanted = needs.socket;
  choose_vertices(draft);
  choose_entries(draft);
  return std::move(draft.plan);
}

void index_faces(const BallSocketPair& joint, double margin, ScanPlan& scan) {
  if (scan.faces && scan.faces->margin() >= margin) return;
  scan.faces = std::make_unique<NearFaces>(mesh_of(joint, other(scan.scanned)), margin);
}

// exp(t) - 1 <= t + t^2 for t in [0, 1].
bool keeps_accuracy(const TableChoice& table, double storage_bound, const NearFaces::Near& near) {
  const double t = near.slope * table.scheme.stencil_radius();
  return t <= 1.0 && near.range.high * t * (1.0 + t) + storage_bound <= *table.accuracy_mm;
}

}  // namespace impinge
