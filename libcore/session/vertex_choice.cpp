// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "files/formatted.hpp"
#include "mesh/surface_vertices.hpp"
#include "session/plan_draft.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

using Chosen = std::vector<std::vector<std::uint32_t>>;  // vertices, of each pose

// A vertex that meets the other surface.
struct MetVertex {
  std::uint32_t vertex;  // place among those of its mesh
  double low;            // mm: its gap is no smaller
};
using Met = std::vector<std::vector<MetVertex>>;  // of each pose

// The vertices of the scan that may have a gap of the limit or less. Where one is proven to touch, away from
// any rim, it is the only one that is listed of the pose; a proven gap of first contact becomes the limit.
Met met_vertices(PlanDraft& draft, const ScanPlan& scan) {
  const bool touch = draft.needs.question == Question::touch;
  const bool first_contact = draft.needs.question == Question::first_contact;
  ScenePlan& plan = draft.plan;
  const TriangleMesh& mesh = mesh_of(draft.joint, scan.scanned);
  const std::vector<VertexIndex> used = surface_vertices(mesh);
  Met met(draft.needs.poses.size());
  for (std::size_t p = 0; p < met.size(); ++p) {
    for (std::size_t k = 0; k < used.size() && !plan.touches[p]; ++k) {
      const Vec3 x = to_other(scan.scanned, draft.needs.poses[p], mesh.vertices[used[k]]);
      const NearFaces::Near near = scan.faces->near(x);
      if (near.nothing()) continue;
      const RadiusRange gap = signed_gap(scan.scanned, near.range, x.norm());
      if (first_contact && !near.rim) plan.limit_mm = std::min(plan.limit_mm, gap.high);
      if (gap.low > plan.limit_mm) continue;
      plan.touches[p] = touch && !near.rim && gap.high <= 0.0;
      if (plan.touches[p]) met[p].clear();
      met[p].push_back({used[k], gap.low});
    }
  }
  return met;
}

// In each pose, those with a gap that may be as small as the limit.
Chosen within(double limit_mm, const Met& met) {
  Chosen chosen(met.size());
  for (std::size_t p = 0; p < met.size(); ++p) {
    for (const MetVertex& vertex : met[p]) {
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

void select(PlanDraft& draft, const Met& met, ScanPlan& scan) {
  Chosen chosen = within(draft.plan.limit_mm, met);
  const bool droppable = scan.scanned == Surface::socket && draft.needs.question != Question::all_gaps &&
                         draft.omissions.has(Omission::second_scan);
  if (droppable && count_of(chosen) == 0) {
    leave_out_second_scan(draft, scan);
  } else if (draft.omissions.has(Omission::vertices)) {
    leave_out_vertices(draft, scan, std::move(chosen));
  }
}

}  // namespace

void choose_vertices(PlanDraft& draft) {
  const Question question = draft.needs.question;
  ScenePlan& plan = draft.plan;
  plan.limit_mm = question == Question::touch ? 0.0 : kInfinity;
  plan.way = question == Question::all_gaps ? "each vertex is looked at: the gaps of all are asked for"
                                            : "each vertex is looked at";
  plan.touches.assign(draft.needs.poses.size(), false);
  if (!draft.omissions.has(Omission::vertices) &&
      (!draft.omissions.has(Omission::second_scan) || question == Question::all_gaps))
    return;
  std::array<Met, 2> met;  // all of both before any is selected, as each may lower the limit
  for (std::size_t k = 0; k < met.size(); ++k) {
    if (!plan.scans[k].wanted) continue;
    index_faces(draft.joint, draft.given.stencil_radius(), plan.scans[k]);
    met[k] = met_vertices(draft, plan.scans[k]);
  }
  for (std::size_t k = 0; k < met.size(); ++k) {
    if (plan.scans[k].wanted) select(draft, met[k], plan.scans[k]);
  }
}

}  // namespace impinge
