// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/turn_limit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/jump_edges.hpp"
#include "mesh/surface_vertices.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

constexpr double kPast =
    1e-9;  // radians behind a contact, where the pose is first tested; doubled while a graze lasts
constexpr int kMostContacts = 64;             // contacts that are looked for in closed form
constexpr double kPoseStep = 0.05 * kDegree;  // radians at most between poses that are tested behind a graze
// Radians: above the rounding from degrees to radians and back. The tolerance of limits/turn_contact.cpp
// allows for the rounding of the pose.
constexpr double kTurnRounding = 1e-12;

Pose pose_at(const JointTurn& turn, double angle) {
  return {turn.outer * Eigen::AngleAxisd(angle, turn.axis).toRotationMatrix() * turn.inner, Vec3::Zero()};
}

bool are_faces_of(const SweptParts& parts, const TriangleMesh& mesh) {
  const std::vector<TurnFace>& all = parts.parts();
  return std::equal(
      all.begin(), all.end(), mesh.faces.begin(), mesh.faces.end(),
      [&](const TurnFace& part, const Face& face) { return part.corner == corners_of(mesh, face); });
}

// The faces of a main surface: those of its bone, if it has no others, or else `own`, which it makes.
const SweptParts& faces_of(const BodyPairs& bodies, Surface of, const TriangleMesh& main, SweptParts& own) {
  const SweptParts& all = bodies.bone(of);
  return are_faces_of(all, main) ? all : own = SweptParts(turn_faces(main));
}

// Where a ball may end, as the centre sees it.
std::vector<Edge> ends_of(const TriangleMesh& ball) {
  std::vector<Edge> ends;
  for (const JumpEdge& edge : jump_edges(ball)) ends.push_back({edge.from, edge.to});
  return ends;
}

}  // namespace

TurnLimits::Answers::Answers(BallSocketPair joint, const BoneParts& beside)
    : bodies(joint, beside),
      meshes{without_edge_on(std::move(joint.ball)), without_edge_on(std::move(joint.socket))},
      ends(bodies.ball_ends() ? ends_of(meshes.ball) : std::vector<Edge>{}),
      seen(surface_vertices(meshes.socket)),
      ball(faces_of(bodies, Surface::ball, meshes.ball, own[0])),
      socket(faces_of(bodies, Surface::socket, meshes.socket, own[1])) {}

TurnLimits::Answers::Answers(CutSurfaces surfaces)
    : bodies(BodyPairs::of_surfaces(surfaces.met)),
      meshes{without_edge_on(std::move(surfaces.main.ball)),
             without_edge_on(std::move(surfaces.main.socket))},
      seen(surface_vertices(meshes.socket)),
      ball(faces_of(bodies, Surface::ball, meshes.ball, own[0])),
      socket(faces_of(bodies, Surface::socket, meshes.socket, own[1])) {
  if (boundary_edges(without_repeats(surfaces.uncut)).empty()) return;
  uncut = without_edge_on(std::move(surfaces.uncut));
  ends = ends_of(uncut);
  whole.emplace(uncut, 0.0);
}

static bool as_many_faces(const BallSocketPair& a, const BallSocketPair& b) {
  return a.ball.faces.size() == b.ball.faces.size() && a.socket.faces.size() == b.socket.faces.size();
}

const CulledJoint& TurnLimits::Answers::vertices() {
  const CulledJoint* made = bodies.radial();
  if (made && as_many_faces(made->meshes(), meshes)) return *made;  // no face was edge-on
  const std::lock_guard lock(making);
  if (!culled) culled.emplace(meshes);
  return *culled;
}

TurnLimits::TurnLimits(BallSocketPair joint, const BoneParts& beside)
    : answers_(std::make_unique<Answers>(std::move(joint), beside)) {}

TurnLimits TurnLimits::of_surfaces(CutSurfaces surfaces) {
  return TurnLimits(std::make_unique<Answers>(std::move(surfaces)));
}

const TurnGap& TurnLimits::gap(double gap_mm) const {
  const std::lock_guard lock(answers_->making);
  return answers_->gaps.try_emplace(gap_mm, answers_->meshes, gap_mm).first->second;
}

std::optional<LeastGap> TurnLimits::smallest_gap(const JointTurn& turn, double angle_deg) const {
  return answers_->vertices().least_gap(pose_at(turn, angle_deg * kDegree));
}

BodyPairs::Verdict TurnLimits::verdict(const JointTurn& turn, double angle_deg) const {
  return answers_->bodies.verdict(pose_at(turn, angle_deg * kDegree));
}

// The first angle found, in steps of kPoseStep, with reached(angle); it is false within kPast before.
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

// next(span) gives the first contact that there may be in the span; gap_reached(angle) tests the threshold.
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
  for (int contacts = 1; !certain; ++contacts) {
    const std::optional<TurnContact> contact = next(AngleSpan{from, largest});
    if (!contact) break;
    last_contact = contact;
    if (limit.state == LimitState::free)
      limit.low_deg = std::max(0.0, contact->angle - kTurnRounding) / kDegree;
    limit.state = LimitState::unknown;
    past = contact->angle > from ? kPast : 2.0 * past;
    const bool last = contacts == kMostContacts;
    from = last ? largest : std::min(contact->angle + past, largest);
    certain = first_reached(contact->angle, from, reached);
    if (from >= largest) break;
  }
  // Into a sheet without a contact: no opening of one is looked for on the way.
  const Pose end = pose_at(turn, largest);
  if (limit.state == LimitState::free &&
      (answers_->bodies.meet(end) || answers_->bodies.verdict(end).contact == Contact::unknown)) {
    limit.state = LimitState::unknown;
    limit.low_deg = 0.0;
  }
  end_of_mesh(turn, largest, certain, limit);
  if (certain) make_limited(turn, *certain, *last_contact, limit);
  return limit;
}

// The contact is given in the frame of the axis.
void TurnLimits::make_limited(const JointTurn& turn, double angle, const TurnContact& contact,
                              TurnLimit& limit) const {
  limit.state = LimitState::limited;
  limit.high_deg = angle / kDegree;
  const double each = 1.0 / (std::abs(contact.normal.dot(turn.axis.cross(contact.place))) * kDegree);
  const Vec3 normal = turn.outer * contact.normal;
  limit.contact = TurnContact{contact.angle, contact.kind, turn.outer * contact.place, normal, contact.body};
  limit.deg_per_mm = each;
  limit.centre_deg_per_mm =
      each * (normal - turn.rest.transpose() * to_ball(pose_at(turn, contact.angle), normal)).norm();
}

MeshEnd TurnLimits::mesh_end(const JointTurn& turn) const {
  const NearFaces& ball = answers_->ball_faces();
  const std::vector<Vec3>& socket = answers_->meshes.socket.vertices;
  const Eigen::Matrix3d upright = rotation_to_z(turn.axis);
  const Eigen::Matrix3d ball_turn = upright * turn.inner;
  const Eigen::Matrix3d socket_turn = upright * turn.outer.transpose();
  MeshEnd end;
  end.border = answers_->ends;
  for (const Vec3& x : ball.mesh().vertices) end.ball.push_back(ball_turn * x);
  for (const VertexIndex v : answers_->seen) end.socket.push_back(socket_turn * socket[v]);
  end.covered = [&](std::size_t point, double angle) {
    const Vec3 y = to_ball(pose_at(turn, angle), socket[answers_->seen[point]]);
    return !y.isZero(0.0) && !std::isnan(ball.radius(y.normalized(), Layer::farthest));
  };
  return end;
}

// Finds where the ball's mesh ends during the turn.
void TurnLimits::end_of_mesh(const JointTurn& turn, double largest, const std::optional<double>& certain,
                             TurnLimit& limit) const {
  if (answers_->ends.empty()) return;
  const auto beyond = first_beyond(mesh_end(turn), certain.value_or(largest));
  if (!beyond) return;
  limit.leaves_mesh_deg = *beyond / kDegree;
  if (limit.state == LimitState::free) limit.state = LimitState::unknown;
  if (!certain) limit.low_deg = std::min(limit.low_deg, *limit.leaves_mesh_deg);
}

TurnLimit TurnLimits::first_contact(const JointTurn& turn, double largest_deg) const {
  const BodyPairs& bodies = answers_->bodies;
  return bracket(
      turn, largest_deg, [&](const AngleSpan& span) { return bodies.first_contact(turn, span); },
      [](double) { return false; });
}

TurnLimit TurnLimits::gap_of(const JointTurn& turn, double gap_mm, double largest_deg) const {
  const TurnGap& asked = gap(gap_mm);
  return bracket(
      turn, largest_deg,
      [&](AngleSpan span) {
        const auto vertex = first_gap(answers_->ball, answers_->socket, turn, asked, span);
        if (vertex) span.to = vertex->angle;
        const auto contact = answers_->bodies.first_contact(turn, span);
        return contact ? contact : vertex;
      },
      [&](double angle) {
        const auto smallest = answers_->vertices().least_gap(pose_at(turn, angle));
        return smallest && smallest->gap_mm <= gap_mm;
      });
}

const CentreIntervals& TurnLimits::intervals(const CentreQuestion& question) const {
  const CulledJoint& vertices = answers_->vertices();
  const std::lock_guard lock(answers_->making);
  const std::array key{static_cast<double>(question.doubt), question.within_mm, question.gap_mm};
  return answers_->intervals
      .try_emplace(key, vertices, answers_->ball, answers_->socket, question, answers_->bodies)
      .first->second;
}

CentreInterval TurnLimits::centre_interval(const JointTurn& turn, const TurnLimit& limit, double largest_deg,
                                           const CentreQuestion& question) const {
  const CentreIntervals& centres = intervals(question);
  CentreInterval interval{0.0, largest_deg, false};
  if (limit.state == LimitState::blocked && question.doubt == CentreDoubt::common &&
      (turn.outer * turn.inner * turn.rest).isIdentity(0.0) && answers_->bodies.meet(pose_at(turn, 0.0)))
    return {0.0, 0.0, true};  // at rest no common centre moves the ball; gaps and radii are of rays from it
  if (limit.state != LimitState::blocked) interval.low_deg = centres.low_deg(turn, limit.low_deg);
  if (limit.state == LimitState::limited || limit.state == LimitState::blocked) {
    const auto high = centres.high_deg(turn, {limit.low_deg, limit.high_deg, largest_deg, limit.contact});
    interval.limited = high.has_value();
    interval.high_deg = high.value_or(largest_deg);
  } else if (!answers_->ends.empty()) {
    const double shift = centres.most_shift(turn, interval.low_deg);
    const auto near =
        first_near_border(mesh_end(turn), interval.low_deg * kDegree, shift, question.within_mm);
    interval.low_deg = near.value_or(interval.low_deg * kDegree) / kDegree;
  }
  return interval;
}

}  // namespace impinge
