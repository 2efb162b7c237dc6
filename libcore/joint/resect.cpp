// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/resect.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "files/formatted.hpp"
#include "hip/hip_measures.hpp"
#include "hip/sphere_fit.hpp"
#include "joint/touch.hpp"
#include "limits/body_pairs.hpp"
#include "mesh/mesh_parts.hpp"
#include "mesh/triangle_distance.hpp"
#include "mesh/weld.hpp"
#include "table/near_faces.hpp"

namespace impinge {
namespace {

// For the least cut, whose faces take longer.
constexpr CutQuestion kLeastQuestion{.closeness = 0.05, .depth_mm = kInfinity, .most_new_faces = 20'000};
// For the rim: the ends of its volume close more slowly than the ball's.
constexpr CutQuestion kRimQuestion{.closeness = 0.05, .depth_mm = 0.2};

constexpr std::string_view kNoVolumeOfBall =
    "along rays of the cut the ball's mesh is open or not of one orientation, so that it is not known where "
    "its bone is";
constexpr std::string_view kNoVolumeOfSocket =
    "the socket is no closed mesh of one orientation with the centre outside of its bone, so that it is not "
    "known how thick its bone is";

// From the joint frame to the files, where the ball lies as scanned; landmarks turn it in the joint.
Vec3 from_joint_frame(const SessionJoint& joint, Surface of, const Vec3& x) {
  const Vec3 at = joint.axes.transpose() * x;
  return (of == Surface::ball ? Vec3(scanned_pose(joint).rotation * at) : at) + joint.joint.centre;
}

std::string at_place(const SessionJoint& joint, Surface of, const Vec3& place) {
  const Vec3 x = from_joint_frame(joint, of, place);
  return formatted("at (%.1f, %.1f, %.1f)", x.x(), x.y(), x.z());
}

// "the ball meets the socket", or with the names of the parts.
std::string meet(const Joint& joint, std::size_t ball, std::size_t socket) {
  return body_name(joint.ball.parts, ball).value_or("the ball") + " meets " +
         body_name(joint.socket.parts, socket).value_or("the socket");
}

// A bone in the joint frame whose main surface was cut, with all that continues it. Vertices of the cut come
// first.
TriangleMesh whole_of(const SessionJoint& joint, const Resection& cut) {
  const JointPart& bone = joint.bone(cut.of);
  TriangleMesh whole = cut.cut;
  for (std::size_t k = 0; k < bone.parts.size() && bone.parts[k].of_main; ++k)
    whole = continued(std::move(whole), in_joint_frame(joint, part_surface(bone.mesh, bone.parts, k)));
  return whole;
}

// Refuses a joint that is not free where all angles are 0.
void require_free_start(const Joint& joint, const TurnLimits& limits, const RequiredLeg& leg,
                        double clearance) {
  JointTurn still = leg.turn;
  still.inner = still.outer = Eigen::Matrix3d::Identity();
  const BodyPairs::Verdict start = limits.verdict(still, 0.0);
  if (start.contact == Contact::yes) {
    throw std::runtime_error(meet(joint, start.pair.ball, start.pair.socket) + " in the " +
                             name_of_rest(joint) +
                             ", before any required motion; check the meshes and the centre");
  }
  const auto gap = limits.smallest_gap(still, 0.0);
  if (gap && gap->gap_mm < clearance)
    throw std::runtime_error(std::string("the ") + name_of_rest(joint) + " has a gap of " +
                             rounded_up(gap->gap_mm, 3) + " mm, less than the clearance; give a smaller one");
}

void require_whole_ball(const RequiredLeg& leg, const TurnLimit& after) {
  const auto leaves = after.leaves_mesh_deg;
  if (!leaves || *leaves > leg.largest_deg) return;
  throw std::runtime_error("the ball's mesh ends under the socket from " + rounded_down(*leaves, 1) +
                           " degrees on of " + describe(leg) +
                           ": what is missing may be in the way; require less, or give more of the bone");
}

// A place where a cut takes bone of the bearing surface.
template <class Bears>
std::optional<Vec3> place_of_cut(const Resection& cut, const Bears& bears) {
  for (std::size_t v = 0; v < cut.depth.size(); ++v)
    if (cut.depth[v] > 0.0 && bears(cut.before.vertices[v])) return cut.before.vertices[v];
  return std::nullopt;
}

std::optional<Vec3> head_cut(const Resection& cut, const TriangleMesh& ball, const RadiiOverCap& socket) {
  SphereFit fit;
  try {
    fit = fit_ball(ball);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // no part of it is a sphere
  }
  return place_of_cut(cut, [&](const Vec3& x) {
    return std::abs((x - fit.centre).norm() - fit.radius) <= fit.trim &&
           !std::isnan(socket.radius(x.normalized()));
  });
}

// The sphere of a socket bears where it goes on all round, `most_rim` mm away.
std::optional<Vec3> socket_cut(const Resection& cut, const TriangleMesh& ball, const TriangleMesh& socket,
                               double most_rim) {
  constexpr int kTried = 24;
  SphereFit fit;
  try {
    fit = measure_acetabulum(socket, fit_ball(ball), Side::right).socket;  // the side changes no sphere
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  const TriangleMesh seen = relative_to(socket, fit.centre);
  const NearFaces faces(seen, 0.0);
  // The tolerance is not the fit's own trim: flat faces are off the sphere where their corners are on it.
  const auto holds = [&](double radius) {
    return std::abs(radius / fit.radius - 1.0) <= BallFitOptions{}.trim;  // NaN: the surface has ended
  };
  return place_of_cut(cut, [&](const Vec3& x) {
    const Vec3 at = x - fit.centre;
    if (!holds(at.norm()) || most_rim >= kPi * fit.radius) return false;  // no place is as far away
    const Vec3 axis = at.normalized();
    const Vec3 beside = Eigen::AngleAxisd(most_rim / fit.radius, axis.unitOrthogonal()) * axis;
    for (int k = 0; k < kTried; ++k) {
      const Vec3 u = Eigen::AngleAxisd(2.0 * kPi * k / kTried, axis) * beside;
      if (!holds(faces.radius(u, Layer::nearest))) return false;
    }
    return true;
  });
}

void require_no_bearing_cut(const SessionJoint& joint, const ResectRequest& request, const Resection& cut,
                            const RadiiOverCap& other) {
  if (request.least) require_no_parts(joint.joint, "the least cut of all");
  const TriangleMesh ball = in_joint_frame(joint, joint.main(Surface::ball));
  if (cut.of == Surface::ball) {
    if (const auto place = head_cut(cut, ball, other))
      throw std::runtime_error("the cut would reach the bearing surface of the ball " +
                               at_place(joint, cut.of, *place) +
                               "; require less, or give a smaller clearance");
    return;
  }
  const TriangleMesh socket = in_joint_frame(joint, joint.main(Surface::socket));
  if (const auto place = socket_cut(cut, ball, socket, request.rim_mm.value_or(kMostRim)))
    throw std::runtime_error("the cut would reach the bearing surface of the socket " +
                             at_place(joint, cut.of, *place) + ", more than " +
                             rounded_up(request.rim_mm.value_or(kMostRim), 1) +
                             " mm inside its rim; require less, or allow more of the rim to go");
}

// The widest bar about an axis through the centre that no cut face enters, on the side of the axis, and where
// a face comes as near.
struct Bar {
  double width = 0.0;
  Vec3 place = Vec3::Zero();
};
std::optional<Bar> bar_of(const TriangleMesh& mesh, const std::vector<double>& depth, const Vec3& axis) {
  std::optional<Bar> bar;
  for (const Face& face : mesh.faces) {
    const bool is_cut = std::ranges::any_of(face, [&](VertexIndex v) { return depth[v] > 0.0; });
    std::array<Vec3, 3> flat = corners_of(mesh, face);
    if (!is_cut || std::ranges::any_of(flat, [&](const Vec3& x) { return x.dot(axis) <= 0.0; })) continue;
    for (Vec3& x : flat) x -= x.dot(axis) * axis;
    const double width =
        2.0 * std::sqrt(squared_distance_to_triangle(Vec3::Zero(), flat[0], flat[1], flat[2]));
    if (!bar || width < bar->width) bar = Bar{width, corner(mesh, face, 0)};
  }
  return bar;
}

std::optional<NeckBar> neck_left(const SessionJoint& joint, const ResectRequest& request,
                                 const Resection& cut, const TriangleMesh& ball) {
  FemurMeasures femur;
  try {
    femur = measure_femur(ball, joint.side.value_or(Side::right));  // the side changes no neck
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  const auto before = bar_of(cut.before, cut.depth, femur.neck_axis);
  const auto after = bar_of(cut.cut, cut.depth, femur.neck_axis);
  if (!before || !after) return std::nullopt;
  const double least = request.neck_mm.value_or(kNeckShare * 2.0 * femur.neck_radius);
  if (after->width < least)
    throw std::runtime_error("the cut would leave a bar of " + rounded_down(after->width, 1) +
                             " mm about the axis of the neck " + at_place(joint, cut.of, after->place) +
                             ", less than " + rounded_up(least, 1) +
                             " mm; require less, or allow a thinner neck");
  return NeckBar{least, before->width, after->width};
}

BoneParts beside_in_joint_frame(const SessionJoint& joint) {
  BoneParts beside = joint.beside();
  for (auto* parts : {&beside.ball, &beside.socket}) {
    for (TriangleMesh& part : *parts) part = in_joint_frame(joint, std::move(part));
  }
  for (auto* whole : {&beside.whole_ball, &beside.whole_socket}) {
    if (*whole) *whole = in_joint_frame(joint, std::move(**whole));
  }
  return beside;
}

bool is_on(const TriangleMesh& mesh, const Vec3& x) {
  constexpr double kOn = 1e-3;  // mm
  return std::ranges::any_of(mesh.faces, [&](const Face& face) {
    const auto [a, b, c] = corners_of(mesh, face);
    return squared_distance_to_triangle(x, a, b, c) <= kOn * kOn;
  });
}

// Refuses bone beside the joint that stops the leg: a part, or what continues a surface of the joint.
void require_no_part_in_the_way(const Joint& joint, const BallSocketPair& surfaces, const RequiredLeg& leg,
                                const TurnLimit& after) {
  if (!after.contact) return;
  const auto [ball, socket] = after.contact->body;
  const Eigen::AngleAxisd turned(after.contact->angle, leg.turn.axis);
  const Eigen::Matrix3d rotation = leg.turn.outer * turned.toRotationMatrix() * leg.turn.inner;
  const Vec3& place = after.contact->place;
  if (ball == 0 && socket == 0 && is_on(surfaces.socket, place) &&
      is_on(surfaces.ball, rotation.transpose() * place))
    return;
  throw std::runtime_error(meet(joint, ball, socket) + " " + rounded_down(after.low_deg, 1) +
                           " degrees into " + describe(leg) +
                           ", and bone beside the joint is not cut; require less");
}

// How far a leg goes with the cut bone.
TurnLimit reached(const SessionJoint& joint, const TurnLimits& cut, Surface of, const RequiredLeg& leg) {
  const double farthest =
      std::min(leg.largest_deg + kBeyondLeg, largest_growth(leg.start, motion_name(leg.growing)));
  TurnLimit after = cut.first_contact(leg.turn, farthest);
  if (!joint.joint.ball.taken) require_whole_ball(leg, after);  // else the rest of the bone is a part
  if (after.low_deg >= leg.largest_deg) return after;
  require_no_part_in_the_way(joint.joint, cut.meshes(), leg, after);
  throw std::runtime_error("the cut " + std::string(name(of)) + " is not proven to reach " + describe(leg) +
                           ", but " + rounded_down(after.low_deg, 3) +
                           (after.high_deg > leg.largest_deg  // no contact is certain before it
                                ? " degrees, where an opening of its mesh leaves it unknown; require less"
                                : " degrees; give a larger clearance"));
}

// One size is within the other, so each sets an end for the other.
void nest(CutSize& inner, CutSize& outer) {
  for (Ends CutSize::*size : {&CutSize::volume_mm3, &CutSize::area_mm2, &CutSize::depth_mm}) {
    (inner.*size).high = std::min((inner.*size).high, (outer.*size).high);
    (outer.*size).low = std::max((outer.*size).low, (inner.*size).low);
  }
}

void add_least(const SessionJoint& joint, LeastCut least, ResectAnswer& found) {
  found.least = LeastExtent{least, least.cells.size()};
  found.swept = std::move(least.cells);
  for (LeastCut::Cell& cell : found.swept) {
    for (Vec3& x : cell.corners) x = from_joint_frame(joint, Surface::ball, x);
  }
}

void add_cut(const SessionJoint& joint, const Resection& cut, TriangleMesh whole, ResectAnswer& found) {
  static_cast<CutSize&>(found) = cut;
  found.surface = cut.of;
  if (!known_ends(found.volume_mm3))
    found.volume_why = cut.of == Surface::ball ? kNoVolumeOfBall : kNoVolumeOfSocket;
  if (!cut.empty()) found.deepest = from_joint_frame(joint, cut.of, cut.before.vertices[cut.deepest]);
  found.mesh_volume_mm3 = cut.cut_mm3;
  found.mesh = std::move(whole);
  for (Vec3& x : found.mesh.vertices) x = from_joint_frame(joint, cut.of, x);
  found.depth = cut.depth;
  found.depth.resize(found.mesh.vertices.size(), 0.0);
}

}  // namespace

void ResectRequest::check() const {
  check_required(require);
  const bool of_ball = cut == Surface::ball;
  if (of_ball && rim_mm)
    throw std::invalid_argument(
        "rim_mm: applies only to a cut of the socket; cut the socket, or leave it out");
  if (!of_ball && neck_mm)
    throw std::invalid_argument("neck_mm: applies only to a cut of the ball; cut the ball, or leave it out");
  if (!of_ball && least)
    throw std::invalid_argument("least: applies only to a cut of the ball; cut the ball, or leave it out");
}

ResectAnswer answer(Session& session, const ResectRequest& request) {
  request.check();
  shift_ball(session, Vec3::Zero());
  const SessionJoint& joint = *session.joint;
  if (joint.joint.socket.taken) {  // the thickness of a wall is known from the whole bone
    Session whole(with_whole_socket(joint.joint), joint.side, joint.joint.axes);
    return answer(whole, request);
  }
  const std::vector<RequiredLeg> legs = required_legs(request.require, joint.side);
  const bool of_ball = request.cut == Surface::ball;
  const TriangleMesh ball = in_joint_frame(joint, joint.main(Surface::ball));
  const TriangleMesh socket = in_joint_frame(joint, joint.main(Surface::socket));
  const BoneParts beside = beside_in_joint_frame(joint);
  const TurnLimits before({ball, socket}, beside);
  require_free_start(joint.joint, before, legs.front(), request.clearance_mm);
  const SweptRadius swept(of_ball ? socket : ball, legs, request.cut);
  CutQuestion question = of_ball ? CutQuestion{} : kRimQuestion;
  question.clearance_mm = request.clearance_mm;
  Resection cut = least_radial_cut(of_ball ? ball : socket, swept, question);
  require_no_bearing_cut(joint, request, cut, swept.other());
  ResectAnswer found;
  if (of_ball) found.neck = neck_left(joint, request, cut, ball);
  TriangleMesh whole = whole_of(joint, cut);
  BoneParts beside_cut = beside;
  auto& whole_beside = of_ball ? beside_cut.whole_ball : beside_cut.whole_socket;
  if (whole_beside) whole_beside = whole;
  const TurnLimits after(of_ball ? BallSocketPair{cut.cut, socket} : BallSocketPair{ball, cut.cut},
                         beside_cut);
  for (const RequiredLeg& leg : legs)
    found.legs.push_back(
        {leg, before.first_contact(leg.turn, leg.largest_deg), reached(joint, after, cut.of, leg)});
  if (request.least) {
    LeastCut least = least_cut(ball, SweptBone(socket, legs, request.clearance_mm), kLeastQuestion);
    nest(least, cut);
    add_least(joint, std::move(least), found);
  }
  add_cut(joint, cut, std::move(whole), found);
  return found;
}

}  // namespace impinge
