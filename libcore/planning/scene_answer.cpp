// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/scene_answer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "mesh/surface_vertices.hpp"

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

std::unique_ptr<RadiusSource> make_source(const BallSocketPair& joint, const ScenePlan& plan,
                                          const ScanPlan& scan, const FillFull& fill_full) {
  const Layer layer = asked_layer(scan.scanned);
  if (!scan.entries) return fill_full(asked_mesh(joint, scan.scanned), layer);
  if (!plan.table.accuracy_mm) return fill_partial(*scan.faces, plan.table.scheme, *scan.entries, layer);
  std::unique_ptr<PartialTable> table;
  if (!plan.table.rays_only) {
    table = fill_partial(*scan.faces, plan.table.scheme, *scan.entries, layer);
    table->store(plan.table.storage);
  }
  return std::make_unique<AccurateSource>(*scan.faces, plan.table, std::move(table), layer);
}

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
    const TriangleMesh& mesh = scanned_mesh(joint_, scan.scanned);
    std::unique_ptr<RadiusSource> source;
    if (has_look_ups(scan)) {
      source = make_source(joint_, plan_, scan, fill_full);
      answer_.cost.bytes += source->bytes();
      answer_.cost.entries += source->entries();
    }
    const std::vector<bool> used = on_surface(mesh);
    for (std::size_t p = 0; p < plan_.poses.size(); ++p) {
      begin_pose(scan.scanned, p, mesh.vertices.size());
      if (needs_.question == Question::touch && touches_[p]) continue;
      const Pose& pose = needs_.poses[plan_.poses[p]];
      const auto look_up = [&](std::size_t v) {
        if (!used[v]) return true;
        const Vec3 x = placed(scan.scanned, pose, mesh.vertices[v]);
        const double radius = source->radius_at(x);
        return note(p, v, scan.scanned == ScannedSurface::ball ? radius - x.norm() : x.norm() - radius);
      };
      if (scan.vertices) {
        answer_.cost.look_ups += (*scan.vertices)[p].size();
        for (const std::uint32_t v : (*scan.vertices)[p]) {
          if (!look_up(v)) break;
        }
      } else {
        answer_.cost.look_ups += mesh.vertices.size();
        for (std::size_t v = 0; v < mesh.vertices.size() && look_up(v); ++v) {
        }
      }
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
  void begin_pose(ScannedSurface scanned, std::size_t p, std::size_t vertices) {
    scanned_ = scanned;
    if (needs_.question != Question::all_gaps) return;
    gaps_ = scanned == ScannedSurface::ball ? &answer_.gaps[p].ball : &answer_.gaps[p].socket;
    gaps_->assign(vertices, kNoSurface);
  }

  // Whether there is more to ask about the pose.
  bool note(std::size_t p, std::size_t vertex, double gap) {
    switch (needs_.question) {
      case Question::touch:
        if (gap <= 0.0) touches_[p] = true;
        return !touches_[p];
      case Question::first_contact:
        if (gap < (answer_.smallest ? answer_.smallest->gap_mm : std::numeric_limits<double>::infinity()))
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
  ScannedSurface scanned_ = ScannedSurface::ball;
  std::vector<double>* gaps_ = nullptr;
};

// Difference of two gaps of one vertex.
double difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0.0;
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : std::abs(a - b);
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, difference(a[i], b[i]));
  return largest;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) ||
           std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool same_bits(const PoseGaps& a, const PoseGaps& b) {
  return same_bits(a.ball, b.ball) && same_bits(a.socket, b.socket);
}

}  // namespace

SceneAnswer answer_scene(const BallSocketPair& joint, const SceneNeeds& needs, const ScenePlan& plan,
                         const FillFull& fill_full) {
  Answering answering(joint, needs, plan);
  for (const ScanPlan& scan : plan.scans) {
    if (scan.wanted) answering.scan(scan, fill_full);
  }
  return answering.finish();
}

bool keeps_promises(const SceneNeeds& needs, const ScenePlan& plan, const SceneAnswer& answer) {
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
  if (!keeps_promises(needs, plan, answer)) {
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

bool same_answer(const SceneAnswer& a, const SceneAnswer& b) {
  if (a.touches != b.touches || a.smallest != b.smallest || a.gaps_of.size() != b.gaps_of.size())
    return false;
  for (std::size_t p = 0; p < a.gaps_of.size(); ++p) {
    if (!same_bits(a.gaps[a.gaps_of[p]], b.gaps[b.gaps_of[p]])) return false;
  }
  return true;
}

double gap_difference(const PoseGaps& a, const PoseGaps& b) {
  return std::max(difference(a.ball, b.ball), difference(a.socket, b.socket));
}

double answer_difference(const SceneAnswer& a, const SceneAnswer& b) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (a.touches != b.touches || a.gaps_of.size() != b.gaps_of.size() || !a.smallest != !b.smallest)
    return kNever;
  double largest = a.smallest ? difference(a.smallest->gap_mm, b.smallest->gap_mm) : 0.0;
  for (std::size_t p = 0; p < a.gaps_of.size(); ++p) {
    largest = std::max(largest, gap_difference(a.gaps[a.gaps_of[p]], b.gaps[b.gaps_of[p]]));
  }
  return largest;
}

}  // namespace impinge
