// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/scene_plan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "detection/formatted.hpp"
#include "planning/reachable.hpp"
#include "planning/table_choice.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr std::size_t kSampled = 8;  // one in so many look-ups is weighed when a table is chosen

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

void choose_poses(const SceneNeeds& needs, Omissions omissions, ScenePlan& plan) {
  for (std::size_t p = 0; p < needs.poses.size(); ++p) {
    const auto seen = std::ranges::find_if(plan.poses, [&](std::size_t q) {
      return omissions.has(Omission::equal_poses) && equal(needs.poses[p], needs.poses[q]);
    });
    plan.same_as.push_back(static_cast<std::size_t>(seen - plan.poses.begin()));
    if (seen == plan.poses.end()) plan.poses.push_back(p);
  }
  const std::size_t again = needs.poses.size() - plan.poses.size();
  if (again == 0) return;
  plan.left_out.push_back(
      {Omission::equal_poses, formatted("%zu of %zu poses came before", again, needs.poses.size()), 0.0});
}

class Planner {
 public:
  Planner(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given, Omissions omissions)
      : joint_(joint), needs_(needs), given_(given), omissions_(omissions), plan_(given) {}

  ScenePlan make() {
    choose_poses(needs_, omissions_, plan_);
    plan_.scans[0].scanned = ScannedSurface::ball;
    plan_.scans[0].wanted = needs_.ball;
    plan_.scans[1].scanned = ScannedSurface::socket;
    plan_.scans[1].wanted = needs_.socket;
    plan_.limit_mm = needs_.question == Question::touch ? 0.0 : kInfinity;
    const bool ranges = omissions_.has(Omission::vertices) ||
                        (omissions_.has(Omission::second_scan) && needs_.question != Question::all_gaps);
    if (omissions_.has(Omission::single_vertices)) choose_way();
    if (ranges || plan_.path.culled) look_around();
    const bool by_accuracy = needs_.accuracy_mm && omissions_.has(Omission::fine_table);
    if (by_accuracy) choose();
    if (omissions_.has(Omission::entries) || by_accuracy) {
      for (ScanPlan& scan : plan_.scans) {
        if (scan.wanted) keep_entries(scan);
      }
    }
    return std::move(plan_);
  }

 private:
  void make_faces(ScanPlan& scan, double stencil_radius) {
    if (scan.faces && scan.faces->margin() >= stencil_radius) return;
    scan.faces = std::make_unique<NearFaces>(asked_mesh(joint_, scan.scanned), stencil_radius);
  }

  template <class Visit>
  void for_each_look_up(const ScanPlan& scan, Visit&& visit) const {
    const TriangleMesh& mesh = scanned_mesh(joint_, scan.scanned);
    for (std::size_t p = 0; p < plan_.poses.size(); ++p) {
      const Pose& pose = needs_.poses[plan_.poses[p]];
      if (scan.vertices) {
        for (const std::uint32_t v : (*scan.vertices)[p]) visit(placed(scan.scanned, pose, mesh.vertices[v]));
      } else {
        for (const Vec3& v : mesh.vertices) visit(placed(scan.scanned, pose, v));
      }
    }
  }

  // Whole caps of vertices at once, where that is allowed and pays.
  void choose_way() {
    if (needs_.question == Question::all_gaps) {
      plan_.path.reason = "each vertex is looked at: the gaps of all are asked for";
      return;
    }
    PathWork work{plan_.poses.size(), 0, 0};
    for (const ScanPlan& scan : plan_.scans) {
      if (!scan.wanted) continue;
      work.vertices += scanned_mesh(joint_, scan.scanned).vertices.size();
      work.faces += asked_mesh(joint_, scan.scanned).faces.size();
    }
    plan_.path = choose_path(work);
  }

  // Decides which vertices and which scans matter.
  void look_around() {
    for (ScanPlan& scan : plan_.scans) {
      if (scan.wanted) make_faces(scan, given_.stencil_radius());
    }
    Reach reach =
        find_reach({joint_, needs_, plan_.poses, plan_.scans, plan_.path.culled}, given_.stencil_radius());
    plan_.limit_mm = reach.limit_mm;
    plan_.touches = std::move(reach.touches);
    plan_.caps_bytes = reach.bytes;
    if (plan_.path.culled)
      plan_.left_out.push_back(
          {Omission::single_vertices, plan_.path.reason, -static_cast<double>(reach.bytes)});
    for (std::size_t k = 0; k < 2; ++k) {
      if (plan_.scans[k].wanted) select(plan_.scans[k], reach.found[k]);
    }
  }

  void select(ScanPlan& scan, const std::vector<std::vector<Reachable>>& found) {
    std::vector<std::vector<std::uint32_t>> chosen(found.size());
    std::size_t count = 0;
    for (std::size_t p = 0; p < found.size(); ++p) {
      for (const Reachable& vertex : found[p]) {
        if (vertex.low <= plan_.limit_mm) chosen[p].push_back(vertex.vertex);
      }
      chosen[p].shrink_to_fit();
      count += chosen[p].size();
    }
    const std::size_t all = found.size() * scanned_mesh(joint_, scan.scanned).vertices.size();
    const bool socket = scan.scanned == ScannedSurface::socket;
    if (socket && count == 0 && needs_.question != Question::all_gaps &&
        omissions_.has(Omission::second_scan)) {
      scan.wanted = false;
      plan_.left_out.push_back(
          {Omission::second_scan,
           formatted("no gap of the socket's vertices can be below %.3g mm%s: the ball's table is not made",
                     plan_.limit_mm, needs_.question == Question::touch ? " where the ball's have none" : ""),
           static_cast<double>(given_.size() * sizeof(double))});
    } else if (omissions_.has(Omission::vertices) || plan_.path.culled) {
      scan.vertices = std::move(chosen);
      plan_.left_out.push_back({Omission::vertices,
                                formatted("%zu of %zu look-ups of the %s's vertices meet no surface%s",
                                          all - count, all, socket ? "socket" : "ball",
                                          std::isinf(plan_.limit_mm)
                                              ? ""
                                              : formatted(" or none within %.3g mm", plan_.limit_mm).c_str()),
                                0.0});
    }
  }

  // The table for the accuracy.
  void choose() {
    std::vector<LookUpNeed> needs;
    RadiusRange range;
    for (ScanPlan& scan : plan_.scans) {
      if (!scan.wanted) continue;
      make_faces(scan, given_.stencil_radius());
      std::size_t k = 0;
      for_each_look_up(scan, [&](const Vec3& x) {
        if (k++ % kSampled != 0) return;
        const NearFaces::Near near = scan.faces->near(x);
        if (near.nothing()) return;
        needs.push_back({near.range.high, near.slope});
        range.include(near.range.low);
        range.include(near.range.high);
      });
    }
    plan_.table = choose_table(needs, kSampled, range, *needs_.accuracy_mm, given_);
    for (ScanPlan& scan : plan_.scans) {
      if (scan.wanted && !plan_.table.rays_only) make_faces(scan, plan_.table.scheme.stencil_radius());
    }
    const std::string instead =
        plan_.table.rays_only
            ? "no table at all: the faces near each vertex are fewer than the entries that it would read"
            : formatted("%s at %g degrees, %d bytes an entry, and faces where that is not proven",
                        std::string(plan_.table.scheme.name()).c_str(), plan_.table.scheme.precision_deg(),
                        plan_.table.storage == Storage::sixteen_bits       ? 2
                        : plan_.table.storage == Storage::single_precision ? 4
                                                                           : 8);
    plan_.left_out.push_back(
        {Omission::fine_table, formatted("%g mm need ", *needs_.accuracy_mm) + instead, 0.0});
  }

  // Those that the look-ups read.
  void keep_entries(ScanPlan& scan) {
    make_faces(scan, plan_.table.scheme.stencil_radius());
    const AnyScheme& scheme = plan_.table.scheme;
    const bool some = omissions_.has(Omission::entries);
    EntrySet entries(plan_.table.rays_only ? 0 : scheme.size());
    if (!plan_.table.rays_only && !some) {
      for (std::size_t i = 0; i < scheme.size(); ++i) entries.insert(i);
    } else if (!plan_.table.rays_only) {
      for_each_look_up(scan, [&](const Vec3& x) {
        if (plan_.table.accuracy_mm && !keeps_accuracy(plan_.table, 0.0, scan.faces->near(x))) return;
        insert_taps(scheme, x, entries);
      });
    }
    entries.number();
    if (some) {
      const double full = static_cast<double>(given_.size()) * sizeof(double);
      const double kept = static_cast<double>(entries.count()) * sizeof(double);
      plan_.left_out.push_back(
          {Omission::entries,
           formatted("%zu of the %s's %zu entries are read", entries.count(),
                     scan.scanned == ScannedSurface::ball ? "socket" : "ball", given_.size()),
           full - kept - static_cast<double>(entries.bytes() + scan.faces->bytes())});
    }
    scan.entries = std::move(entries);
  }

  const BallSocketPair& joint_;
  const SceneNeeds& needs_;
  const AnyScheme& given_;
  Omissions omissions_;
  ScenePlan plan_;
};

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
  return Planner(joint, needs, given, omissions).make();
}

// exp(t) - 1 <= t + t^2 for t in [0, 1].
bool keeps_accuracy(const TableChoice& table, double storage_bound, const NearFaces::Near& near) {
  const double t = near.slope * table.scheme.stencil_radius();
  return t <= 1.0 && near.range.high * t * (1.0 + t) + storage_bound <= *table.accuracy_mm;
}

}  // namespace impinge
