// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "files/formatted.hpp"
#include "hip/named_motion.hpp"
#include "joint/document.hpp"
#include "joint/pose_answer.hpp"
#include "joint/touch.hpp"
#include "mesh/edges.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

double largest_of(const LimitRequest& request) {
  return std::min(request.largest_deg, largest_growth(request.start, motion_name(request.growing)));
}

// Where bones meet: at the contact of a limit, or where a blocked motion has its deepest vertex.
struct Meeting {
  Vec3 place;            // mm, about the centre of the turn, socket at rest
  Eigen::Matrix3d ball;  // the ball's rotation there
  std::array<std::size_t, 2> body;
  double within_mm;  // how far along its ray from the place each surface is, at most
};

std::optional<Meeting> meeting_of(const CentredLimits& centred, const JointTurn& turn,
                                  const ToldLimit& told) {
  const auto at = [&](double angle) {
    return Eigen::Matrix3d(turn.outer * Eigen::AngleAxisd(angle, turn.axis).toRotationMatrix() * turn.inner);
  };
  if (const auto& contact = told.limit.contact)
    return Meeting{contact->place, at(contact->angle), contact->body, told.threshold_mm};
  if (told.limit.state != LimitState::blocked) return std::nullopt;
  const auto least = centred.limits.smallest_gap(turn, 0.0);
  if (!least || least->gap_mm > told.threshold_mm) return std::nullopt;
  const bool of_ball = least->at.scanned == Surface::ball;
  const Vec3& x = mesh_of(centred.limits.meshes(), least->at.scanned).vertices[least->at.vertex];
  return Meeting{of_ball ? Vec3(at(0.0) * x) : x, at(0.0), {}, HUGE_VAL};
}

std::optional<UnknownBy> unknown_by(const CentredLimits& centred, const JointTurn& turn,
                                    const TurnLimit& limit) {
  constexpr double kBeyond = 0.01;  // degrees: within an opening that a bone came to
  if (limit.state != LimitState::unknown) return std::nullopt;
  if (limit.leaves_mesh_deg && *limit.leaves_mesh_deg <= limit.low_deg) return UnknownBy::end_of_ball;
  for (const double angle : {limit.low_deg, std::min(limit.low_deg + kBeyond, limit.high_deg)})
    if (centred.limits.verdict(turn, angle).contact == Contact::unknown) return UnknownBy::opening;
  const BodyPairs::Verdict end = centred.limits.verdict(turn, limit.high_deg);
  if (end.contact != Contact::no && end.rule == ContactRule::inside) return UnknownBy::opening;
  return UnknownBy::graze;
}

// A point of a surface, about the centre of the turn. At a gap one surface is at `place` and the other
// elsewhere along its ray.
Vec3 point_of(SessionJoint& joint, Surface of, const Vec3& place, double within_mm) {
  if (within_mm == 0.0) return place;
  const Vec3 u = place.stableNormalized();
  const double radius = joint.faces(of).radius(joint.axes.transpose() * u,
                                               of == Surface::ball ? Layer::farthest : Layer::nearest);
  return std::abs(radius - place.norm()) <= within_mm ? Vec3(radius * u) : place;
}

// The bodies that touch where a turn begins, if one is a part; the deepest vertex is on a main surface.
std::optional<BodyPairs::Pair> blocked_by_part(const CentredLimits& centred, const JointTurn& turn,
                                               const ToldLimit& told) {
  if (told.limit.state != LimitState::blocked || told.threshold_mm != 0.0) return std::nullopt;
  const BodyPairs::Pair pair = centred.limits.verdict(turn, 0.0).pair;
  return pair.ball + pair.socket > 0 ? std::optional(pair) : std::nullopt;
}

// Finds places of the joint, and forgets limits of the other kind, for the rim alone or not.
void find_places(Session& session, bool rim) {
  const SessionJoint& joint = *session.joint;
  const Joint& bones = joint.joint;
  if (!session.places)
    session.places =
        joint_places({in_joint_frame(joint, bones.ball.main()), in_joint_frame(joint, bones.socket.main())});
  if (session.limits_of_rim != rim) {
    session.limits.reset();
    session.socket_limits.reset();
    session.limits_of_rim = rim;
  }
}

// The limits about the centre of the ball, or of the socket, which has one.
const CentredLimits& limits_about(Session& session, Surface of) {
  constexpr std::size_t kKeepBoth = 1'000'000;  // faces: of more only one is kept, for half of the memory
  const SessionJoint& joint = *session.joint;
  const bool of_ball = of == Surface::ball;
  auto& limits = of_ball ? session.limits : session.socket_limits;
  if (limits) return *limits;
  BallSocketPair about{in_joint_frame(joint, joint.mesh(Surface::ball)),
                       in_joint_frame(joint, joint.mesh(Surface::socket))};
  if (about.ball.faces.size() + about.socket.faces.size() > kKeepBoth)
    (of_ball ? session.socket_limits : session.limits).reset();
  const Vec3 centre = of_ball ? Vec3(joint.axes * joint.shift) : session.places->socket->centre;
  const Vec3 origin = of_ball ? Vec3(Vec3::Zero()) : centre;  // the ball is about its own centre
  if (!of_ball) about = {relative_to(about.ball, origin), relative_to(about.socket, origin)};
  limits = session.limits_of_rim ? std::make_unique<CentredLimits>(joint.joint, std::move(about), centre,
                                                                   origin, *session.places)
                                 : std::make_unique<CentredLimits>(joint.joint, std::move(about), centre);
  return *limits;
}

LimitAnswer answered(Session& session, const LimitRequest& asked, Surface about, double threshold) {
  SessionJoint& joint = *session.joint;
  const bool of_socket = about == Surface::socket;
  const CentredLimits& centred = limits_about(session, about);
  JointTurn turn = joint_turn(asked.start, motion_name(asked.growing), joint.side);
  turn.rest = turn_from_scan(joint);
  LimitAnswer limit;
  limit.motion = asked.motion.empty() ? asked.growing : asked.motion;
  limit.centre = name(about);
  limit.start = asked.start;
  limit.largest_deg = largest_of(asked);
  limit.told = told_limit(centred.limits, turn, threshold, limit.largest_deg);
  limit.unknown_by = unknown_by(centred, turn, limit.told.limit);
  limit.centre_of_rotation = joint.joint.centre + joint.axes.transpose() * centred.centre;
  if (const auto& contact = limit.told.limit.contact)
    limit.position = joint.axes.transpose() * contact->place + limit.centre_of_rotation;
  if (const auto pair = blocked_by_part(centred, turn, limit.told)) {
    limit.ball_part = body_name(joint.joint.ball.parts, pair->ball).value_or("ball");
    limit.socket_part = body_name(joint.joint.socket.parts, pair->socket).value_or("socket");
    return limit;
  }
  const auto at = meeting_of(centred, turn, limit.told);
  if (!at) return limit;
  if (joint.dial) limit.hours = joint.dial->hours(at->place + centred.centre);
  const Vec3 ball_centre = of_socket ? centred.centre : Vec3::Zero();  // the ball is about its own centre
  const Vec3 x = point_of(joint, Surface::ball, at->ball.transpose() * at->place, at->within_mm);
  const Vec3 y = point_of(joint, Surface::socket, at->place, at->within_mm);
  const auto [ball, socket] = at->body;
  limit.ball_part =
      body_name(joint.joint.ball.parts, ball).value_or(place_on_ball(*session.places, ball_centre + x));
  limit.socket_part = body_name(joint.joint.socket.parts, socket)
                          .value_or(place_on_socket(*session.places, centred.centre + y));
  return limit;
}

// How far from the head's centre the ball's bone is cut through its neck, mm: an opening there is longer than
// a thin neck is round. A whole bone and a shaft go on for more than 4 radii; a cap ends on the sphere.
std::optional<double> neck_cut(const SessionJoint& joint, const SphereFit& head) {
  constexpr double kNeckFrom = 1.2;  // head radii from the centre
  constexpr double kNeckTo = 2.0;
  constexpr double kRound = 3.0;  // head radii: real necks are cut along 5.5 to 6.2
  const JointPart& ball = joint.joint.ball;
  if (ball.validation.boundary_edges == 0) return std::nullopt;
  const TriangleMesh bone = in_joint_frame(joint, weld(whole_main(ball.mesh, ball.parts)));
  double nearest = std::numeric_limits<double>::infinity();
  double length = 0.0;
  for (const auto& [a, b] : boundary_edges(bone)) {
    const Vec3 from = bone.vertices[a] - head.centre;
    const Vec3 to = bone.vertices[b] - head.centre;
    const double low = std::min(from.norm(), to.norm());
    if (low < kNeckFrom * head.radius || std::max(from.norm(), to.norm()) > kNeckTo * head.radius) continue;
    nearest = std::min(nearest, low);
    length += (to - from).norm();
  }
  return length > kRound * head.radius ? std::optional(nearest) : std::nullopt;
}

// Of each request, as answer_limits() has them. All have the same translation and are for the rim alone or
// not. One centre is asked about after the other.
std::vector<LimitAnswer> answer_each(Session& session, const std::vector<LimitRequest>& requests) {
  if (requests.empty()) return {};
  const LimitRequest& any = requests.front();
  for (const LimitRequest& request : requests) largest_of(request);  // refuses what cannot grow
  shift_ball(session, any.translation);
  find_places(session, any.rim);
  std::vector<std::vector<LimitAnswer>> found(requests.size());
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const double cartilage = requests[k].cartilage_mm;
    found[k].push_back(answered(session, requests[k], Surface::ball, 0.0));
    if (cartilage > 0.0) found[k].push_back(answered(session, requests[k], Surface::ball, cartilage));
  }
  if (any.translation.isZero(0.0) && session.places->socket)
    for (std::size_t k = 0; k < requests.size(); ++k)
      found[k].insert(found[k].begin() + 1, answered(session, requests[k], Surface::socket, 0.0));
  std::vector<LimitAnswer> all;
  for (std::vector<LimitAnswer>& of : found) std::move(of.begin(), of.end(), std::back_inserter(all));
  return all;
}

}  // namespace

CentredLimits::CentredLimits(const Joint& joint, BallSocketPair about, const Vec3& from_centre)
    : meshes(std::move(about)),
      centre(from_centre),
      limits({main_surface(meshes.ball, joint.ball.parts), main_surface(meshes.socket, joint.socket.parts)},
             bone_parts({meshes.ball, joint.ball.parts}, {meshes.socket, joint.socket.parts})) {}

// The surfaces for the rim alone.
static CutSurfaces rim_of(const Joint& joint, const BallSocketPair& meshes, const Vec3& origin,
                          const Vec3& ball_origin, const JointPlaces& places) {
  CutSurfaces cut;
  in_field("rim", [&] {
    cut.met = {whole_main(meshes.ball, joint.ball.parts), whole_main(meshes.socket, joint.socket.parts)};
    cut.main.ball = main_surface(meshes.ball, joint.ball.parts);
    if (cut.main.ball.faces.size() == cut.met.ball.faces.size()) cut.uncut = cut.main.ball;
    leave_rim(places, origin, cut.met.socket);
    leave_off_head(places, ball_origin, cut.met.ball);
    leave_off_head(places, ball_origin, cut.main.ball);
    cut.main.socket = cut.met.socket;
  });
  return cut;
}

CentredLimits::CentredLimits(const Joint& joint, BallSocketPair about, const Vec3& from_centre,
                             const Vec3& ball_origin, const JointPlaces& places)
    : meshes(std::move(about)),
      centre(from_centre),
      limits(TurnLimits::of_surfaces(rim_of(joint, meshes, from_centre, ball_origin, places))) {}

std::vector<LimitAnswer> answer_limits(Session& session, const LimitRequest& request) {
  return answer_each(session, {request});
}

std::optional<std::string> LimitRow::meets() const {
  return ball_part ? std::optional(meeting_words(*ball_part, *socket_part)) : std::nullopt;
}

std::string LimitRow::what() const {
  std::string what = meets().value_or("");
  const auto add = [&what](const std::string& doubt) { what += (what.empty() ? "" : "; ") + doubt; };
  if (told.hangs_on_less()) add(told.sensitivity());
  if (told.limit.leaves_mesh_deg)
    add("the ball's mesh ends from " + rounded_down(*told.limit.leaves_mesh_deg, 1));
  if (unknown_by == UnknownBy::opening) add("hangs on an opening of a mesh");
  if (unknown_by == UnknownBy::graze) add("surfaces graze");
  return what;
}

void LimitsRequest::check() const {
  in_field("motions", [this] {
    for (const std::string& name : motions)
      if (!is_rest(named_motion(name).start) && pose)
        throw std::invalid_argument(name + " begins at a pose of its own; leave the pose out");
  });
}

LimitsAnswer answer(Session& session, const LimitsRequest& request) {
  request.check();
  LimitsAnswer answer{.centre_within_mm = kErrorOfInput, .rim = request.rim, .limits = {}};
  std::vector<LimitRequest> each;
  for (const NamedMotion& motion : named_motions()) {
    const bool named = std::any_of(request.motions.begin(), request.motions.end(),
                                   [&](const std::string& name) { return &named_motion(name) == &motion; });
    if (!(request.motions.empty() ? !request.pose || is_rest(motion.start) : named)) continue;
    each.push_back({.start = request.pose.value_or(motion.start),
                    .growing = std::string(motion.growing),
                    .motion = motion.name,
                    .largest_deg = request.largest_deg,
                    .translation = request.translation.value_or(Vec3::Zero()),
                    .cartilage_mm = request.cartilage_mm,
                    .rim = request.rim});
  }
  try {
    answer.limits = answer_each(session, each);
  } catch (...) {
    shift_ball(session, Vec3::Zero());
    throw;
  }
  shift_ball(session, Vec3::Zero());  // other questions are about the joint as it lies
  if (session.places && session.places->head)
    answer.ball_cut_mm = neck_cut(*session.joint, *session.places->head);
  if (request.rim && session.places) answer.rim_in_head_mm = rim_in_head(*session.places);
  return answer;
}

Sweep sweep(Session& session, const LimitRequest& request, double step_deg) {
  const MotionName& growing = motion_name(request.growing);
  Motion end = request.start;
  end.*growing.angle += growing.sign * largest_of(request);
  Sweep found;
  for (const Motion& motion : motion_path(request.start, end, step_deg)) {
    const auto smallest = answer_pose(session, {motion, request.translation, 0.0}).smallest_gap;
    found.angles.push_back(growing.sign * (motion.*growing.angle - request.start.*growing.angle));
    found.smallest.push_back(smallest ? smallest->gap_mm : std::numeric_limits<double>::quiet_NaN());
  }
  return found;
}

}  // namespace impinge
