// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_plan.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "gap/formatted.hpp"
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

// Measured with generated joints of 600 to 200,000 faces in both surfaces and 361 poses: the caps take 2.4 to
// 7 us a face, their trees included, and 1 to 4 us a pose; a vertex takes 23 to 50 ns along a path without
// contact, and 18 to 27 along one that touches in most poses, which are decided as soon as a vertex is proven
// to touch. So the caps begin to pay at 210 to 390 poses, and the estimate costs at most a third of the time
// around there.
std::optional<std::size_t> caps_pay_from(std::size_t vertices, std::size_t faces) {
  constexpr double kCapsPerFace = 4000.0;  // ns, of both limits
  constexpr double kLookPerVertex = 28.0;  // ns
  constexpr double kCulledPerPose = 2e3;   // ns
  const double gain = kLookPerVertex * static_cast<double>(vertices) - kCulledPerPose;
  if (gain <= 0.0) return std::nullopt;
  return static_cast<std::size_t>(std::floor(kCapsPerFace * static_cast<double>(faces) / gain)) + 1;
}

// exp(t) - 1 <= t + t^2 for t in [0, 1].
bool keeps_accuracy(const TableChoice& table, double storage_bound, const NearFaces::Near& near) {
  const double t = near.slope * table.scheme.stencil_radius();
  return t <= 1.0 && near.range.high * t * (1.0 + t) + storage_bound <= *table.accuracy_mm;
}

}  // namespace impinge
