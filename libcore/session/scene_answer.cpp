// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_answer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/surface_vertices.hpp"
#include "sphere/infinity.hpp"
#include "sphere/scheme_choice.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

// A table where it keeps the accuracy, and the faces themselves elsewhere: beyond the bound and next to a
// rim.
class AccurateSource final : public RadiusSource {
 public:
  AccurateSource(const NearFaces& faces, const TableChoice& choice, std::unique_ptr<PartialTable> table,
                 Layer layer)
      : faces_(faces), choice_(choice), table_(std::move(table)), layer_(layer) {}

  double radius_at(const Vec3& x) const override {
    const NearFaces::Near near = faces_.near(x);
    if (near.nothing()) return kNoSurface;
    if (table_ && keeps_accuracy(choice_, table_->storage_bound(), near)) {
      const double radius = table_->radius_at(x);
      if (!std::isnan(radius)) return radius;
    }
    return faces_.radius(x.normalized(), near, layer_);
  }
  std::size_t bytes() const override { return table_ ? table_->bytes() : 0; }
  std::size_t entries() const override { return table_ ? table_->entries() : 0; }

 private:
  const NearFaces& faces_;
  const TableChoice& choice_;
  std::unique_ptr<PartialTable> table_;
  Layer layer_;
};

std::unique_ptr<RadiusSource> whole_table(const AnyScheme& scheme, const TriangleMesh& mesh, Layer layer) {
  std::unique_ptr<RadiusSource> table;
  with_scheme(scheme.name(), [&]<class S>() {
    table =
        std::make_unique<FullTable<S>>(fill_exact(mesh, S::with_precision(scheme.precision_deg()), layer));
  });
  return table;
}

// The whole table, the part of it that the plan keeps, or with an accuracy a table where it keeps that and
// the faces elsewhere. Joint, plan and scan must outlive it.
std::unique_ptr<RadiusSource> source_of(const BallSocketPair& joint, const ScenePlan& plan,
                                        const ScanPlan& scan) {
  const Layer layer = facing_layer(other(scan.scanned));
  const TableChoice& choice = plan.table;
  if (!scan.entries) return whole_table(choice.scheme, mesh_of(joint, other(scan.scanned)), layer);
  if (!choice.accuracy_mm) return fill_partial(*scan.faces, choice.scheme, *scan.entries, layer);
  std::unique_ptr<PartialTable> table;
  if (!choice.rays_only) {
    table = fill_partial(*scan.faces, choice.scheme, *scan.entries, layer);
    table->store(choice.storage);
  }
  return std::make_unique<AccurateSource>(*scan.faces, choice, std::move(table), layer);
}

bool has_look_ups(const ScanPlan& scan) {
  return !scan.vertices || std::ranges::any_of(*scan.vertices, [](const auto& v) { return !v.empty(); });
}

class Answering {
 public:
  Answering(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan)
      : joint_(joint), needs_(needs), plan_(plan) {
    answer_.cost.bytes = plan.bytes();
    if (needs.question == Question::touch) answer_.touches.assign(needs.poses.size(), false);
    if (needs.question == Question::all_gaps) answer_.gaps.resize(needs.poses.size());
  }

  void scan(const ScanPlan& scan) {
    std::unique_ptr<RadiusSource> source;
    if (has_look_ups(scan)) {
      source = source_of(joint_, plan_, scan);
      answer_.cost.bytes += source->bytes();
      answer_.cost.entries += source->entries();
    }
    const std::vector<bool> used = on_surface(mesh_of(joint_, scan.scanned));
    for (std::size_t p = 0; p < needs_.poses.size(); ++p) {
      begin_pose(scan.scanned, p, used.size());
      if (needs_.question == Question::touch && answer_.touches[p]) continue;
      scan_pose(scan, p, used, source.get());
    }
  }

  SceneAnswer finish() { return std::move(answer_); }

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
    const auto look_up = [&](std::size_t v) {
      if (!used[v]) return true;
      const Vec3 x = to_other(scan.scanned, needs_.poses[p], mesh.vertices[v]);
      return note(p, v, signed_gap(scan.scanned, source->radius_at(x), x.norm()));
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
        if (gap <= 0.0) answer_.touches[p] = true;
        return !answer_.touches[p];
      case Question::first_contact:
        if (gap < (answer_.smallest ? answer_.smallest->gap_mm : kInfinity))
          answer_.smallest = SmallestGap{gap, scanned_, p, vertex};
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
  Surface scanned_ = Surface::ball;
  std::vector<double>* gaps_ = nullptr;
};

}  // namespace

SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan) {
  Answering answering(joint, needs, plan);
  for (const ScanPlan& scan : plan.scans) {
    if (scan.wanted) answering.scan(scan);
  }
  return answering.finish();
}

bool is_as_planned(const SceneNeeds& needs, const ScenePlan& plan, const SceneAnswer& answer) {
  if (needs.question == Question::first_contact)
    return std::isinf(plan.limit_mm) || (answer.smallest && answer.smallest->gap_mm <= plan.limit_mm);
  if (needs.question != Question::touch) return true;
  for (std::size_t p = 0; p < plan.touches.size(); ++p) {
    if (plan.touches[p] && !answer.touches[p]) return false;
  }
  return true;
}

SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given,
                         Omissions omissions) {
  ScenePlan plan = plan_scene(joint, needs, given, omissions);
  SceneAnswer answer = answer_scene(joint, needs, plan);
  if (!is_as_planned(needs, plan, answer)) {
    plan =
        plan_scene(joint, needs, given, omissions.without(Omission::vertices).without(Omission::second_scan));
    answer = answer_scene(joint, needs, plan);
  }
  answer.way = std::move(plan.way);
  answer.left_out = std::move(plan.left_out);
  return answer;
}

}  // namespace impinge
