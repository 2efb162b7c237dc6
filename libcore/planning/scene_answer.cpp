// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/scene_answer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/surface_vertices.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

bool has_look_ups(const ScanPlan& scan) {
  return !scan.vertices || std::ranges::any_of(*scan.vertices, [](const auto& v) { return !v.empty(); });
}

class Answering {
 public:
  Answering(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan)
      : joint_(joint), needs_(needs), plan_(plan) {
    answer_.cost.bytes = plan.bytes();
    if (needs.question == Question::touch) touches_.assign(plan.poses.size(), false);
    if (needs.question == Question::all_gaps) answer_.gaps.resize(plan.poses.size());
  }

  void scan(const ScanPlan& scan, const FillFull& fill_full) {
    std::unique_ptr<RadiusSource> source;
    if (has_look_ups(scan)) {
      source = make_scan_source(joint_, plan_, scan, fill_full);
      answer_.cost.bytes += source->bytes();
      answer_.cost.entries += source->entries();
    }
    const std::vector<bool> used = on_surface(mesh_of(joint_, scan.scanned));
    for (std::size_t p = 0; p < plan_.poses.size(); ++p) {
      begin_pose(scan.scanned, p, used.size());
      if (needs_.question == Question::touch && touches_[p]) continue;
      scan_pose(scan, p, used, source.get());
    }
  }

  SceneAnswer finish() {
    for (const std::size_t p : plan_.same_as) {
      if (needs_.question == Question::touch) answer_.touches.push_back(touches_[p]);
    }
    if (needs_.question == Question::all_gaps) answer_.gaps_of = plan_.same_as;
    return std::move(answer_);
  }

 private:
  void begin_pose(Surface scanned, std::size_t p, std::size_t vertices) {
    scanned_ = scanned;
    if (needs_.question != Question::all_gaps) return;
    gaps_ = scanned == Surface::ball ? &answer_.gaps[p].ball : &answer_.gaps[p].socket;
    gaps_->assign(vertices, kNoSurface);
  }

  // Notes the gaps of the scan's vertices, so far as they are `used`, until there is no more to ask. A scan
  // without look-ups has no source.
  void scan_pose(const ScanPlan& scan, std::size_t p, const std::vector<bool>& used,
                 const RadiusSource* source) {
    const TriangleMesh& mesh = mesh_of(joint_, scan.scanned);
    const Pose& pose = needs_.poses[plan_.poses[p]];
    const auto look_up = [&](std::size_t v) {
      if (!used[v]) return true;
      const Vec3 x = to_other(scan.scanned, pose, mesh.vertices[v]);
      const double radius = source->radius_at(x);
      return note(p, v, signed_gap(scan.scanned, radius, x.norm()));
    };
    if (scan.vertices) {
      answer_.cost.look_ups += (*scan.vertices)[p].size();
      static_cast<void>(std::ranges::all_of((*scan.vertices)[p], look_up));
    } else {
      answer_.cost.look_ups += mesh.vertices.size();
      for (std::size_t v = 0; v < mesh.vertices.size() && look_up(v); ++v) {
      }
    }
  }

  // Whether there is more to ask about the pose.
  bool note(std::size_t p, std::size_t vertex, double gap) {
    switch (needs_.question) {
      case Question::touch:
        if (gap <= 0.0) touches_[p] = true;
        return !touches_[p];
      case Question::first_contact:
        if (gap < (answer_.smallest ? answer_.smallest->gap_mm : kInfinity))
          answer_.smallest = SmallestGap{gap, scanned_, plan_.poses[p], vertex};
        return true;
      case Question::all_gaps:
        break;
    }
    (*gaps_)[vertex] = gap;
    return true;
  }

  const BallSocketPair& joint_;
  const SceneNeeds& needs_;
  const ScenePlan& plan_;
  SceneAnswer answer_;
  std::vector<bool> touches_;  // of the poses that are looked at
  Surface scanned_ = Surface::ball;
  std::vector<double>* gaps_ = nullptr;
};

}  // namespace

SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan,
                         const FillFull& fill_full) {
  Answering answering(joint, needs, plan);
  for (const ScanPlan& scan : plan.scans) {
    if (scan.wanted) answering.scan(scan, fill_full);
  }
  return answering.finish();
}

bool is_as_planned(const SceneNeeds& needs, const ScenePlan& plan, const SceneAnswer& answer) {
  if (needs.question == Question::first_contact)
    return std::isinf(plan.limit_mm) || (answer.smallest && answer.smallest->gap_mm <= plan.limit_mm);
  if (needs.question != Question::touch || plan.touches.empty()) return true;
  for (std::size_t p = 0; p < needs.poses.size(); ++p) {
    if (plan.touches[plan.same_as[p]] && !answer.touches[p]) return false;
  }
  return true;
}

SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given,
                         Omissions omissions, const FillFull& fill_full, std::vector<LeftOut>* left_out) {
  ScenePlan plan = plan_scene(joint, needs, given, omissions);
  SceneAnswer answer = answer_scene(joint, needs, plan, fill_full);
  if (!is_as_planned(needs, plan, answer)) {
    const Omissions safe = omissions.without(Omission::vertices)
                               .without(Omission::second_scan)
                               .without(Omission::single_vertices);
    plan = plan_scene(joint, needs, given, safe);
    answer = answer_scene(joint, needs, plan, fill_full);
  }
  answer.path = std::move(plan.path);
  if (left_out) *left_out = std::move(plan.left_out);
  return answer;
}

}  // namespace impinge
