// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/known_turn.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "contact/culled_joint.hpp"
#include "contact/moved_faces.hpp"
#include "limits/turn_limit.hpp"
#include "methods/contact.hpp"
#include "reference/meeting_surfaces.hpp"

namespace impinge::lab {
namespace {

constexpr double kClear = 1e-9;      // mm, distance of the bones in the pose before their contact
constexpr double kSkin = 1e-5;       // mm, see kTurnMutation
constexpr double kPoseDoubt = 64.0;  // roundings, u R each, by which a pose may move a bone, with a margin

double reach_of(const KnownTurn& known) {
  double reach = 0.0;
  for (const TriangleMesh* mesh : {&known.bones.ball, &known.bones.socket})
    for (const Vec3& x : mesh->vertices) reach = std::max(reach, x.norm());
  return reach;
}

Pose pose_at(const JointTurn& turn, double angle) {
  return {turn.outer * Eigen::AngleAxisd(angle, turn.axis).toRotationMatrix() * turn.inner, Vec3::Zero()};
}

StabilityCase blank(double magnitude, std::string method, std::string kind, double step_deg = 0.0) {
  StabilityCase row;
  row.magnitude = magnitude;
  row.method = std::move(method);
  row.kind = std::move(kind);
  row.precision_deg = step_deg;
  row.threshold = kTurnThreshold;
  return row;
}

// The bracket as a bound: half its width, about its middle.
void judge_bracket(StabilityCase& row, const KnownTurn& known, const TurnLimit& limit) {
  const double contact = *known.contact;
  const double unit = reach_of(known) * unit_roundoff(row.scalar) / known.rate;  // radians
  const double low = limit.low_deg * kDegree;
  const double high = limit.high_deg * kDegree;
  const double outside = std::max({0.0, low - contact, contact - high}) / unit;
  row.condition = std::fmax(row.condition, reach_of(known) / (known.rate * contact));
  row.error_over_condition_u = std::fmax(row.error_over_condition_u, outside);
  if (outside > row.threshold) ++row.wrong;
  const double error = std::abs(0.5 * (low + high) - contact);
  row.relative_error = std::fmax(row.relative_error, error / contact);
  const double to_um = 1e3 * reach_of(known);
  const double bound = to_um * (0.5 * (high - low) + row.threshold * unit);
  if (std::isnan(row.bound_um) || to_um * error / bound > row.error_um / row.bound_um) {
    row.bound_um = bound;
    row.error_um = to_um * error;
  }
}

void judge_limit(StabilityCase& row, const KnownTurn& known, const TurnLimit& limit) {
  ++row.questions;
  const bool touches = known.contact.has_value();
  if (!touches) row.condition = std::fmax(row.condition, reach_of(known) / std::abs(known.depth_mm));
  switch (limit.state) {
    case LimitState::free:
      row.missed_hits += touches ? 1U : 0U;
      return;
    case LimitState::blocked:
      ++row.false_hits;
      return;
    case LimitState::unknown:
      ++(touches && limit.low_deg * kDegree > *known.contact * (1.0 + 1e-9) ? row.wrong : row.withheld);
      return;
    case LimitState::limited:
      break;
  }
  if (touches)
    judge_bracket(row, known, limit);
  else
    ++row.false_hits;
}

using PoseTest = std::function<bool(const Pose&)>;

// The first pose that touches must be the one after the contact, if any.
void judge_steps(StabilityCase& row, const KnownTurn& known, const PoseTest& touches) {
  ++row.questions;
  const double step = row.precision_deg * kDegree;
  for (int k = 0; k * row.precision_deg <= known.largest_deg; ++k) {
    if (!touches(pose_at(known.turn, k * step))) continue;
    if (!known.contact || k * step < *known.contact - 1e-9)
      ++row.false_hits;
    else if (k * step > *known.contact + step + 1e-9)
      ++row.missed_hits;
    return;
  }
  if (known.contact) ++row.missed_hits;
}

// Tests just before the contact and in the deepest pose, unless rounding decides there.
void judge_poses(StabilityCase& row, const KnownTurn& known, const PoseTest& touches) {
  if (std::abs(known.depth_mm) > kPoseDoubt * reach_of(known) * unit_roundoff(Scalar::float64)) {
    ++row.questions;
    const bool found = touches(pose_at(known.turn, known.deepest));
    if (found && known.depth_mm < 0.0) ++row.false_hits;
    if (!found && known.depth_mm > 0.0) ++row.missed_hits;
  }
  if (!known.contact) return;
  ++row.questions;
  if (touches(pose_at(known.turn, *known.contact - kClear / known.rate))) ++row.false_hits;
}

TriangleMesh moved(TriangleMesh mesh, const Pose& pose) {
  for (Vec3& x : mesh.vertices) x = to_socket(pose, x);
  return mesh;
}

PoseTest exact_test(const BallSocketPair& bones) {
  return [ball = std::make_shared<const MovedFaces>(bones.ball),
          socket = std::make_shared<const FixedFaces>(bones.socket)](const Pose& pose) {
    return surfaces_meet(*ball, *socket, pose);
  };
}

PoseTest cgal_test(const BallSocketPair& bones) {
  return [&bones](const Pose& pose) { return surfaces_meet(moved(bones.ball, pose), bones.socket); };
}

// Moves each vertex of the ball, which is convex, away from its middle.
BallSocketPair with_skin(BallSocketPair bones, double skin_mm) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& x : bones.ball.vertices) middle += x / static_cast<double>(bones.ball.vertices.size());
  for (Vec3& x : bones.ball.vertices) x += skin_mm * (x - middle).normalized();
  return bones;
}

// The rows of one magnitude: each turn adds to them; libraries come last.
struct Rows {
  explicit Rows(double magnitude)
      : at(magnitude),
        exact(blank(magnitude, "first_contact", "ours")),
        mutated(blank(magnitude, "mutated", "mutated")),
        exact_poses(blank(magnitude, "exact_test", "ours")),
        cgal(blank(magnitude, "cgal_pairs", "library")) {
    for (const double step : kTurnSteps) {
      faces.push_back(blank(magnitude, "exact_test_in_steps", "steps", step));
      vertices.push_back(blank(magnitude, "vertex_gaps_in_steps", "thesis", step));
    }
  }

  void add(const KnownTurn& known) {
    judge_limit(exact, known, TurnLimits(known.bones).first_contact(known.turn, known.largest_deg));
    judge_limit(mutated, known,
                TurnLimits(with_skin(known.bones, kSkin)).first_contact(known.turn, known.largest_deg));
    const PoseTest meet = exact_test(known.bones);
    const CulledJoint joint(known.bones);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      judge_steps(faces[k], known, meet);
      judge_steps(vertices[k], known,
                  [&joint](const Pose& pose) { return joint.impinged(pose).has_value(); });
    }
    judge_poses(exact_poses, known, meet);
    judge_poses(cgal, known, cgal_test(known.bones));
    std::size_t k = 0;
    for (const ContactCase& one : cases_of(steps_methods(), &Method::steps, known.bones)) {
      if (k == libraries.size()) libraries.push_back(blank(at, one.name, "library"));
      judge_poses(libraries[k++], known, one.make().touches);
    }
  }

  std::vector<StabilityCase> all() const {
    std::vector<StabilityCase> rows{exact, mutated, exact_poses, cgal};
    for (const auto* more : {&faces, &vertices, &libraries})
      rows.insert(rows.end(), more->begin(), more->end());
    return rows;
  }

  double at;
  StabilityCase exact;
  StabilityCase mutated;
  StabilityCase exact_poses;
  StabilityCase cgal;
  std::vector<StabilityCase> faces;
  std::vector<StabilityCase> vertices;
  std::vector<StabilityCase> libraries;
};

}  // namespace

std::vector<StabilityCase> judge_turns(double magnitude, std::span<const KnownTurn> turns) {
  Rows rows(magnitude);
  for (const KnownTurn& known : turns) rows.add(known);
  return rows.all();
}

std::vector<StabilityCase> over_turns(std::span<const double> magnitudes, const StabilityRun& run,
                                      const std::function<KnownTurn(std::size_t, double)>& turn_at) {
  std::vector<StabilityCase> rows;
  for (const double magnitude : magnitudes) {
    std::vector<KnownTurn> turns;
    for (std::size_t k = 0; k < (run.quick ? 9U : 60U); ++k) turns.push_back(turn_at(k, magnitude));
    const std::vector<StabilityCase> judged = judge_turns(magnitude, turns);
    rows.insert(rows.end(), judged.begin(), judged.end());
  }
  return rows;
}

}  // namespace impinge::lab
