// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/reachable.hpp"

#include <algorithm>
#include <optional>

#include "contact/culled_scan.hpp"
#include "contact/touch_search.hpp"
#include "mesh/surface_vertices.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr std::size_t kWholePoses = 8;  // of a path: all of their vertices set the first limit

class ReachSearch {
 public:
  ReachSearch(const ReachTask& task, double stencil_radius) : task_(task) {
    reach_.touches.assign(task.poses.size(), false);
    reach_.limit_mm = touch() ? 0.0 : kInfinity;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!task.scans[k].wanted) continue;
      const Surface scanned = task.scans[k].scanned;
      if (task.culled) {
        culled_[k].emplace(scanned, mesh_of(task.joint, scanned), mesh_of(task.joint, other(scanned)),
                           stencil_radius);
        reach_.bytes += culled_[k]->bytes();
      }
      vertices_[k] = surface_vertices(mesh_of(task.joint, scanned));
      reach_.found[k].resize(task.poses.size());
    }
  }

  Reach run() {
    if (task_.culled && first_contact()) look_at_whole_poses();
    for (std::size_t k = 0; k < 2; ++k) {
      if (!task_.scans[k].wanted) continue;
      for (std::size_t p = 0; p < task_.poses.size(); ++p) {
        if (!reach_.touches[p]) look_at(k, p);
      }
    }
    return std::move(reach_);
  }

 private:
  bool touch() const { return task_.needs.question == Question::touch; }
  bool first_contact() const { return task_.needs.question == Question::first_contact; }
  const Pose& pose(std::size_t p) const { return task_.needs.poses[task_.poses[p]]; }

  // Of the vertex of scan k in pose p; empty where it meets nothing. A gap of first contact sets the limit.
  RadiusRange gap_range(std::size_t k, std::size_t p, std::uint32_t v, bool& rim) {
    const ScanPlan& scan = task_.scans[k];
    const Vec3 x = to_other(scan.scanned, pose(p), mesh_of(task_.joint, scan.scanned).vertices[v]);
    const NearFaces::Near near = scan.faces->near(x);
    rim = near.rim;
    if (near.nothing()) return {};
    const RadiusRange gap = signed_gap(scan.scanned, near.range, x.norm());
    if (first_contact() && !rim) reach_.limit_mm = std::min(reach_.limit_mm, gap.high);
    return gap;
  }

  void look_at_whole_poses() {
    const std::size_t step = 1 + task_.poses.size() / kWholePoses;
    bool rim = false;
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t p = 0; p < task_.poses.size(); p += step) {
        for (const std::uint32_t v : vertices_[k]) gap_range(k, p, v, rim);
      }
    }
  }

  // Lists what matters of scan k in pose p.
  void look_at(std::size_t k, std::size_t p) {
    std::vector<Reachable>& found = reach_.found[k][p];
    const auto take = [&](std::uint32_t v) {
      bool rim = false;
      const RadiusRange gap = gap_range(k, p, v, rim);
      if (gap.empty() || gap.low > reach_.limit_mm) return;
      reach_.touches[p] = touch() && !rim && gap.high <= 0.0;
      if (reach_.touches[p]) found.clear();
      found.push_back({v, gap.low});
    };
    if (!culled_[k]) {
      for (std::size_t i = 0; i < vertices_[k].size() && !reach_.touches[p]; ++i) take(vertices_[k][i]);
      return;
    }
    const CulledScan& culled = *culled_[k];
    auto visit = [&](std::uint32_t item) {
      take(culled.vertex(item));
      return reach_.touches[p] ? -kInfinity : reach_.limit_mm;
    };
    const PosedTree posed{culled.tree(), culled.limits(), CapMove(culled.scanned(), pose(p))};
    visit_near(posed, reach_.limit_mm, visit);
    std::ranges::sort(found, {}, &Reachable::vertex);
  }

  const ReachTask& task_;
  std::array<std::optional<CulledScan>, 2> culled_;
  std::array<std::vector<std::uint32_t>, 2> vertices_;
  Reach reach_;
};

}  // namespace

Reach find_reach(const ReachTask& task, double stencil_radius) {
  return ReachSearch(task, stencil_radius).run();
}

}  // namespace impinge
