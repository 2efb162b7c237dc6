// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/turn_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

namespace impinge {
namespace {

// Angles past a contact at which it may be deep enough to be seen in doubles, radians; the last is still
// below a tenth of a degree.
constexpr std::array kPast{1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3};
constexpr double kTurnRounding = 1e-12;  // of an angle, radians: between the two ways of turning
constexpr int kMostGrazes = 32;          // places that are passed within the tolerance

Pose pose_at(const JointTurn& turn, double angle) {
  return {turn.outer * Eigen::AngleAxisd(angle, turn.axis).toRotationMatrix() * turn.inner, Vec3::Zero()};
}

// Degrees that the limit moves by for one millimetre across the contact. axis and contact in one frame.
double deg_per_mm(const TurnContact& contact, const Vec3& axis) {
  return 1.0 / (std::abs(contact.normal.dot(axis.cross(contact.place))) * kDegree);
}

}  // namespace

std::string_view name(LimitState state) {
  switch (state) {
    case LimitState::reached:
      return "reached";
    case LimitState::free:
      return "free";
    case LimitState::blocked:
      break;
  }
  return "blocked";
}

TurnLimits::Answers::Answers(BallSocketPair joint)
    : meshes(std::move(joint)), vertices(meshes), surfaces(vertices) {}

TurnLimits::TurnLimits(BallSocketPair joint)
    : answers_(std::make_unique<const Answers>(std::move(joint))),
      ball_parts_(answers_->meshes.ball),
      socket_parts_(answers_->meshes.socket) {}

TurnContacts TurnLimits::contacts(const JointTurn& turn, double largest_gap) const {
  return TurnContacts({{answers_->meshes.ball, ball_parts_, turn.inner},
                       {answers_->meshes.socket, socket_parts_, turn.outer.transpose()},
                       turn.axis,
                       largest_gap});
}

bool TurnLimits::impinged(const JointTurn& turn, double angle_deg) const {
  return answers_->surfaces.impinged(pose_at(turn, angle_deg * kDegree));
}

std::optional<VertexGap> TurnLimits::smallest_gap(const JointTurn& turn, double angle_deg) const {
  const Pose pose = pose_at(turn, angle_deg * kDegree);
  const auto least = answers_->vertices.least_gap(pose);
  if (!least) return std::nullopt;
  const BallSocketPair& meshes = answers_->meshes;
  const std::size_t v = least->at.vertex;
  const bool ball = least->at.scanned == ScannedSurface::ball;
  return VertexGap{least->gap_mm,
                   ball ? to_socket(pose, meshes.ball.vertices[v]) : meshes.socket.vertices[v]};
}

// next(span) is the first contact that may be in it, reached(angle) makes certain.
template <class Next, class Reached>
TurnLimit TurnLimits::bracket(const JointTurn& turn, double largest_deg, const Next& next,
                              const Reached& reached) const {
  if (!(largest_deg > 0.0 && largest_deg <= 360.0))
    throw std::invalid_argument("the largest angle of a motion is above 0 and no more than 360 degrees");
  TurnLimit limit{LimitState::free, largest_deg, largest_deg, std::nullopt, 0.0};
  if (reached(0.0)) return {LimitState::blocked, 0.0, 0.0, std::nullopt, 0.0};
  const double largest = largest_deg * kDegree;
  double from = 0.0;
  for (int graze = 0; graze < kMostGrazes; ++graze) {
    const std::optional<TurnContact> contact = next(AngleSpan{from, largest});
    if (!contact) return limit;
    const double low_deg = std::max(0.0, contact->angle - kTurnRounding) / kDegree;
    limit.low_deg = std::min(limit.low_deg, low_deg);
    for (const double past : kPast) {
      const double angle = std::min(contact->angle + past, largest);
      if (!reached(angle)) continue;
      limit.state = LimitState::reached;
      limit.high_deg = angle / kDegree;
      limit.contact = contact;
      limit.deg_per_mm = deg_per_mm(*contact, turn.axis);
      limit.contact->place = turn.outer * contact->place;
      limit.contact->normal = turn.outer * contact->normal;
      return limit;
    }
    from = contact->angle + kPast.back();
    if (from >= largest) return limit;
  }
  return limit;
}

TurnLimit TurnLimits::first_contact(const JointTurn& turn, double largest_deg) const {
  const TurnContacts found = contacts(turn, 0.0);
  return bracket(
      turn, largest_deg, [&](const AngleSpan& span) { return found.first(span); },
      [&](double angle) { return answers_->surfaces.impinged(pose_at(turn, angle)); });
}

TurnLimit TurnLimits::gap_of(const JointTurn& turn, double gap_mm, double largest_deg) const {
  const TurnContacts found = contacts(turn, gap_mm);
  return bracket(
      turn, largest_deg, [&](const AngleSpan& span) { return found.first_gap(gap_mm, span); },
      [&](double angle) {
        const auto smallest = answers_->vertices.least_gap(pose_at(turn, angle));
        return smallest && smallest->gap_mm <= gap_mm;
      });
}

}  // namespace impinge
