// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/resection.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "gap/formatted.hpp"
#include "hip/hip_measures.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

// Of the least cut, whose faces take longer.
constexpr CutQuestion kLeastQuestion{.closeness = 0.05, .most_new_faces = 20'000};

std::string at_place(const SessionJoint& joint, const Vec3& place) {
  const Vec3 x = joint.axes.transpose() * place + joint.joint.centre;
  return formatted("at (%.1f, %.1f, %.1f)", x.x(), x.y(), x.z());
}

// The pose of the scan must be one that is kept.
void require_free_start(const TurnLimits& limits, const RequiredLeg& leg, double clearance) {
  JointTurn still = leg.turn;
  still.inner = still.outer = Eigen::Matrix3d::Identity();
  if (limits.impinged(still, 0.0))
    throw std::runtime_error(
        "the bones touch in the pose of the scan, before any required motion; check the meshes and the "
        "centre");
  const auto gap = limits.smallest_gap(still, 0.0);
  if (gap && gap->gap_mm < clearance)
    throw std::runtime_error("the pose of the scan has a gap of " + rounded_up(gap->gap_mm, 3) +
                             " mm, less than the clearance; give a smaller one");
}

void require_whole_ball(const ReachedLeg& reached) {
  const auto leaves = reached.after.leaves_mesh_deg;
  if (!leaves || *leaves > reached.leg.largest_deg) return;
  throw std::runtime_error("the ball's mesh ends under the socket from " + rounded_down(*leaves, 1) +
                           " degrees on of " + describe(reached.leg) +
                           ": what is missing may be in the way; require less, or give more of the bone");
}

// The place of a cut on the bearing surface.
std::optional<Vec3> bearing_cut(const Resection& cut, const TriangleMesh& ball, const RadiiOverCap& socket) {
  SphereFit fit;
  try {
    fit = fit_ball(ball);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // nothing of it is a sphere
  }
  for (std::size_t v = 0; v < cut.depth.size(); ++v) {
    const Vec3& x = cut.before.vertices[v];
    if (cut.depth[v] > 0.0 && std::abs((x - fit.centre).norm() - fit.radius) <= fit.trim &&
        !std::isnan(socket.radius(x.normalized())))
      return x;
  }
  return std::nullopt;
}

// Width of the widest bar about an axis through the centre that the cut faces of a mesh stay out of, on its
// own side, and where they come as near.
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

std::optional<NeckBar> neck_left(const SessionJoint& joint, const ResectionRequest& request,
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
  const double least = request.least_neck_mm.value_or(kNeckShare * 2.0 * femur.neck_radius);
  if (after->width < least)
    throw std::runtime_error("the cut would leave a bar of " + rounded_down(after->width, 1) +
                             " mm about the axis of the neck " + at_place(joint, after->place) +
                             ", less than " + rounded_up(least, 1) +
                             " mm; require less, or allow a thinner neck");
  return NeckBar{least, before->width, after->width};
}

void reach(const TriangleMesh& socket, ResectionAnswer& answer) {
  const TurnLimits after({answer.cut.cut, socket});
  for (ReachedLeg& reached : answer.legs) {
    const RequiredLeg& leg = reached.leg;
    const double farthest =
        std::min(leg.largest_deg + kBeyondLeg, largest_growth(leg.start, motion_name(leg.growing)));
    reached.after = after.first_contact(leg.turn, farthest);
    require_whole_ball(reached);
    if (reached.after.low_deg < leg.largest_deg)
      throw std::runtime_error("the cut ball is not proven to reach " + describe(leg) + ", but " +
                               rounded_down(reached.after.low_deg, 3) + " degrees; give a larger clearance");
  }
}

// What is within what: the ends of one hold for the other.
void nest(CutSize& inner, CutSize& outer) {
  for (Ends CutSize::*size : {&CutSize::volume_mm3, &CutSize::area_mm2, &CutSize::depth_mm}) {
    (inner.*size).high = std::min((inner.*size).high, (outer.*size).high);
    (outer.*size).low = std::max((outer.*size).low, (inner.*size).low);
  }
}

}  // namespace

ResectionAnswer answer_resection(Session& session, const ResectionRequest& request) {
  const SessionJoint& joint = *session.joint;
  require_no_parts(joint.joint, "resection");
  const std::vector<RequiredLeg> legs = required_legs(request.required, joint.side);
  if (legs.empty()) throw std::runtime_error("no motion is required");
  const TriangleMesh ball = in_joint_frame(joint, joint.mesh(Surface::ball));
  const TriangleMesh socket = in_joint_frame(joint, joint.mesh(Surface::socket));
  const TurnLimits limits({ball, socket});
  require_free_start(limits, legs.front(), request.clearance_mm);
  const SweptRadius swept(socket, legs);
  ResectionAnswer answer{
      least_radial_cut(ball, swept, {.clearance_mm = request.clearance_mm}), {}, {}, {}, {}};
  for (const RequiredLeg& leg : legs)
    answer.legs.push_back({leg, limits.first_contact(leg.turn, leg.largest_deg), {}});
  const TriangleMesh head = in_joint_frame(joint, joint.main(Surface::ball));
  if (const auto place = bearing_cut(answer.cut, head, swept.socket()))
    throw std::runtime_error("the cut would reach the bearing surface of the ball " +
                             at_place(joint, *place) + "; require less, or give a smaller clearance");
  answer.neck = neck_left(joint, request, answer.cut, head);
  reach(socket, answer);
  if (request.least) {
    answer.least = least_cut(ball, SweptBone(socket, legs, request.clearance_mm), kLeastQuestion);
    nest(*answer.least, answer.cut);
  }
  answer.deepest =
      joint.axes.transpose() * answer.cut.before.vertices[answer.cut.deepest] + joint.joint.centre;
  return answer;
}

}  // namespace impinge
