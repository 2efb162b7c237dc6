// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/turn_limit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/surface_vertices.hpp"
#include "motion/mesh_end.hpp"

namespace impinge {
namespace {

constexpr double kPast =
    1e-9;  // radians past a contact, where it is first asked for; doubled while a graze lasts
constexpr int kMostContacts = 64;             // that are looked at in closed form
constexpr double kPoseStep = 0.05 * kDegree;  // at most between poses that are asked for behind a graze
// Of an angle, radians, between one in degrees and one in radians. A pose that is rounded differs from the
// turn by about 1e-15 of the radius, which the tolerance of motion/turn_contact.hpp holds.
constexpr double kTurnRounding = 1e-12;

Pose pose_at(const JointTurn& turn, double angle) {
  return {turn.outer * Eigen::AngleAxisd(angle, turn.axis).toRotationMatrix() * turn.inner, Vec3::Zero()};
}

}  // namespace

std::string_view name(LimitState state) {
  switch (state) {
    case LimitState::limited:
      return "limited";
    case LimitState::free:
      return "free";
    case LimitState::blocked:
      return "blocked";
    case LimitState::unknown:
      break;
  }
  return "unknown";
}

// The earliest of all pairs of bodies.
template <class Next>
static std::optional<TurnContact> earliest(const std::vector<TurnContacts>& contacts, AngleSpan span,
                                           const Next& next) {
  std::optional<TurnContact> first;
  for (const TurnContacts& of : contacts) {
    const std::optional<TurnContact> found = next(of, span);
    if (!found || (first && found->angle >= first->angle)) continue;
    first = found;
    span.to = found->angle;
  }
  return first;
}

TurnLimits::Answers::Answers(BallSocketPair joint, const BoneParts& beside)
    : bodies(joint, beside),
      meshes{without_edge_on(std::move(joint.ball)), without_edge_on(std::move(joint.socket))},
      vertices(meshes),
      ends(bodies.ball_ends() ? boundary_edges(meshes.ball) : std::vector<Edge>{}),
      seen(surface_vertices(meshes.socket)) {}

TurnLimits::TurnLimits(BallSocketPair joint, const BoneParts& beside)
    : answers_(std::make_unique<const Answers>(std::move(joint), beside)),
      ball_parts_(answers_->meshes.ball, true),
      socket_parts_(answers_->meshes.socket, true) {}

std::optional<LeastGap> TurnLimits::smallest_gap(const JointTurn& turn, double angle_deg) const {
  return answers_->vertices.least_gap(pose_at(turn, angle_deg * kDegree));
}

BodyPairs::Verdict TurnLimits::verdict(const JointTurn& turn, double angle_deg) const {
  return answers_->bodies.verdict(pose_at(turn, angle_deg * kDegree));
}

// An angle that is reached, asked for in steps; next to it, within kPast, is one that is not.
template <class Reached>
static std::optional<double> first_reached(double from, double to, const Reached& reached) {
  for (double before = from; before < to; before = std::min(before + kPoseStep, to)) {
    double at = std::min(before + kPoseStep, to);
    if (!reached(at)) continue;
    while (at - before > kPast) {
      const double middle = 0.5 * (before + at);
      (reached(middle) ? at : before) = middle;
    }
    return at;
  }
  return std::nullopt;
}

// next(span) is the first contact that may be in it; gap_reached(angle) makes certain of a threshold.
template <class Next, class Reached>
TurnLimit TurnLimits::bracket(const JointTurn& turn, double largest_deg, const Next& next,
                              const Reached& gap_reached) const {
  if (!(largest_deg > 0.0 && largest_deg <= 360.0))
    throw std::invalid_argument("the largest angle of a motion is above 0 and no more than 360 degrees");
  const Contact start = verdict(turn, 0.0).contact;
  if (start == Contact::yes || gap_reached(0.0))
    return {LimitState::blocked, 0.0, 0.0, std::nullopt, 0.0, 0.0, std::nullopt};
  if (start == Contact::unknown)
    return {LimitState::unknown, 0.0, largest_deg, std::nullopt, 0.0, 0.0, std::nullopt};
  const auto reached = [&](double angle) {
    return gap_reached(angle) || answers_->bodies.meet(pose_at(turn, angle));
  };
  const double largest = largest_deg * kDegree;
  TurnLimit limit{LimitState::free, largest_deg, largest_deg, std::nullopt, 0.0, 0.0, std::nullopt};
  double from = 0.0;
  double past = kPast;
  std::optional<double> certain;
  std::optional<TurnContact> last_contact;
  for (int contacts = 0; contacts < kMostContacts && !certain; ++contacts) {
    const std::optional<TurnContact> contact = next(AngleSpan{from, largest});
    if (!contact) break;
    last_contact = contact;
    if (limit.state == LimitState::free)
      limit.low_deg = std::max(0.0, contact->angle - kTurnRounding) / kDegree;
    limit.state = LimitState::unknown;
    past = contact->angle > from ? kPast : 2.0 * past;
    const bool last = contacts + 1 == kMostContacts;
    from = last ? largest : std::min(contact->angle + past, largest);
    certain = first_reached(contact->angle, from, reached);
    if (from >= largest) break;
  }
  end_of_mesh(turn, largest, certain, limit);
  if (certain) make_limited(turn, *certain, *last_contact, limit);
  return limit;
}

// The contact is still before the turn's last part.
void TurnLimits::make_limited(const JointTurn& turn, double angle, const TurnContact& contact,
                              TurnLimit& limit) const {
  limit.state = LimitState::limited;
  limit.high_deg = angle / kDegree;
  const double each = 1.0 / (std::abs(contact.normal.dot(turn.axis.cross(contact.place))) * kDegree);
  const Vec3 normal = turn.outer * contact.normal;
  limit.contact = TurnContact{contact.angle, contact.kind, turn.outer * contact.place, normal, contact.body};
  limit.deg_per_mm = each;
  limit.centre_deg_per_mm = each * (normal - to_ball(pose_at(turn, contact.angle), normal)).norm();
}

// The mesh of the ball may end before the motion does.
void TurnLimits::end_of_mesh(const JointTurn& turn, double largest, const std::optional<double>& certain,
                             TurnLimit& limit) const {
  if (answers_->ends.empty()) return;
  const BallSocketPair& meshes = answers_->meshes;
  const Eigen::Matrix3d upright = rotation_to_z(turn.axis);
  const Eigen::Matrix3d ball_turn = upright * turn.inner;
  const Eigen::Matrix3d socket_turn = upright * turn.outer.transpose();
  MeshEnd end;
  end.border = answers_->ends;
  for (const Vec3& x : meshes.ball.vertices) end.ball.push_back(ball_turn * x);
  for (const VertexIndex v : answers_->seen) end.socket.push_back(socket_turn * meshes.socket.vertices[v]);
  end.covered = [&](std::size_t point, double angle) {
    const Vec3& y = meshes.socket.vertices[answers_->seen[point]];
    return !std::isnan(answers_->vertices.gap(Surface::socket, to_ball(pose_at(turn, angle), y)));
  };
  const auto beyond = first_beyond(end, certain.value_or(largest));
  if (!beyond) return;
  limit.leaves_mesh_deg = *beyond / kDegree;
  if (limit.state == LimitState::free) limit.state = LimitState::unknown;
  if (!certain) limit.low_deg = std::min(limit.low_deg, *limit.leaves_mesh_deg);
}

TurnLimit TurnLimits::first_contact(const JointTurn& turn, double largest_deg) const {
  const std::vector<TurnContacts> bodies = answers_->bodies.contacts(turn);
  return bracket(
      turn, largest_deg,
      [&](const AngleSpan& span) {
        return earliest(bodies, span,
                        [](const TurnContacts& of, const AngleSpan& in) { return of.first(in); });
      },
      [](double) { return false; });
}

TurnLimit TurnLimits::gap_of(const JointTurn& turn, double gap_mm, double largest_deg) const {
  const std::vector<TurnContacts> bodies = answers_->bodies.contacts(turn);
  const TurnContacts vertices({{answers_->meshes.ball, ball_parts_, turn.inner},
                               {answers_->meshes.socket, socket_parts_, turn.outer.transpose()},
                               turn.axis,
                               gap_mm,
                               {}});
  return bracket(
      turn, largest_deg,
      [&](AngleSpan span) {
        const auto gap = vertices.first_gap(gap_mm, span);
        if (gap) span.to = gap->angle;
        const auto contact = earliest(
            bodies, span, [](const TurnContacts& of, const AngleSpan& in) { return of.first(in); });
        return contact ? contact : gap;
      },
      [&](double angle) {
        const auto smallest = answers_->vertices.least_gap(pose_at(turn, angle));
        return smallest && smallest->gap_mm <= gap_mm;
      });
}

CentreInterval TurnLimits::centre_interval(const JointTurn& turn, const TurnLimit& limit,
                                           const CentreQuestion& question) const {
  return impinge::centre_interval(centre_intervals(question), turn, limit);
}

CentreIntervals TurnLimits::centre_intervals(const CentreQuestion& question) const {
  return {answers_->vertices, question, answers_->bodies};
}

CentreInterval centre_interval(const CentreIntervals& intervals, const JointTurn& turn,
                               const TurnLimit& limit) {
  const double largest = intervals.question().largest_deg;
  CentreInterval interval{0.0, largest, false};
  if (limit.state != LimitState::blocked) interval.low_deg = intervals.low_deg(turn, limit.low_deg);
  if (limit.state == LimitState::limited || limit.state == LimitState::blocked) {
    const std::optional<double> high = intervals.high_deg(turn, {limit.low_deg, limit.high_deg});
    interval.limited = high.has_value();
    interval.high_deg = high.value_or(largest);
  }
  return interval;
}

}  // namespace impinge
