// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/vertex_choice.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "gap/formatted.hpp"
#include "planning/reachable.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

using Chosen = std::vector<std::vector<std::uint32_t>>;

// Whole caps of vertices at once, where that is allowed and pays.
PathChoice chosen_way(const PlanDraft& draft) {
  PathChoice way;
  if (!draft.omissions.has(Omission::single_vertices)) return way;
  if (draft.needs.question == Question::all_gaps) {
    way.reason = "each vertex is looked at: the gaps of all are asked for";
    return way;
  }
  PathWork work{draft.plan.poses.size(), 0, 0};
  for (const ScanPlan& scan : draft.plan.scans) {
    if (!scan.wanted) continue;
    work.vertices += mesh_of(draft.joint, scan.scanned).vertices.size();
    work.faces += mesh_of(draft.joint, other(scan.scanned)).faces.size();
  }
  return choose_path(work);
}

// In each pose, those with a gap that may be as small as the limit.
Chosen within(double limit_mm, const std::vector<std::vector<Reachable>>& found) {
  Chosen chosen(found.size());
  for (std::size_t p = 0; p < found.size(); ++p) {
    for (const Reachable& vertex : found[p]) {
      if (vertex.low <= limit_mm) chosen[p].push_back(vertex.vertex);
    }
    chosen[p].shrink_to_fit();
  }
  return chosen;
}

std::size_t count_of(const Chosen& chosen) {
  std::size_t count = 0;
  for (const auto& of_pose : chosen) count += of_pose.size();
  return count;
}

void leave_out_second_scan(PlanDraft& draft, ScanPlan& scan) {
  scan.wanted = false;
  const char* const where = draft.needs.question == Question::touch ? " where the ball's have none" : "";
  draft.plan.left_out.push_back(
      {Omission::second_scan,
       formatted("no gap of the socket's vertices can be below %.3g mm%s: the ball's table is not made",
                 draft.plan.limit_mm, where),
       static_cast<double>(draft.given.size() * sizeof(double))});
}

void leave_out_vertices(PlanDraft& draft, ScanPlan& scan, Chosen chosen) {
  const std::size_t all = chosen.size() * mesh_of(draft.joint, scan.scanned).vertices.size();
  const std::size_t kept = count_of(chosen);
  const double limit = draft.plan.limit_mm;
  const std::string beyond = std::isinf(limit) ? "" : formatted(" or none within %.3g mm", limit);
  draft.plan.left_out.push_back({Omission::vertices,
                                 formatted("%zu of %zu look-ups of the %s's vertices meet no surface%s",
                                           all - kept, all, name(scan.scanned).data(), beyond.c_str()),
                                 0.0});
  scan.vertices = std::move(chosen);
}

void select(PlanDraft& draft, const std::vector<std::vector<Reachable>>& found, ScanPlan& scan) {
  Chosen chosen = within(draft.plan.limit_mm, found);
  const bool droppable = scan.scanned == Surface::socket && draft.needs.question != Question::all_gaps &&
                         draft.omissions.has(Omission::second_scan);
  if (droppable && count_of(chosen) == 0) {
    leave_out_second_scan(draft, scan);
  } else if (draft.omissions.has(Omission::vertices) || draft.plan.path.culled) {
    leave_out_vertices(draft, scan, std::move(chosen));
  }
}

void find_near_vertices(PlanDraft& draft) {
  const double stencil_radius = draft.given.stencil_radius();
  ScenePlan& plan = draft.plan;
  for (ScanPlan& scan : plan.scans) {
    if (scan.wanted) index_faces(draft.joint, stencil_radius, scan);
  }
  Reach reach =
      find_reach({draft.joint, draft.needs, plan.poses, plan.scans, plan.path.culled}, stencil_radius);
  plan.limit_mm = reach.limit_mm;
  plan.touches = std::move(reach.touches);
  plan.caps_bytes = reach.bytes;
  if (plan.path.culled)
    plan.left_out.push_back({Omission::single_vertices, plan.path.reason, -static_cast<double>(reach.bytes)});
  for (std::size_t k = 0; k < plan.scans.size(); ++k) {
    if (plan.scans[k].wanted) select(draft, reach.found[k], plan.scans[k]);
  }
}

}  // namespace

void choose_vertices(PlanDraft& draft) {
  const Question question = draft.needs.question;
  draft.plan.limit_mm = question == Question::touch ? 0.0 : kInfinity;
  draft.plan.path = chosen_way(draft);
  const bool wanted = draft.omissions.has(Omission::vertices) ||
                      (draft.omissions.has(Omission::second_scan) && question != Question::all_gaps);
  if (wanted || draft.plan.path.culled) find_near_vertices(draft);
}

}  // namespace impinge
