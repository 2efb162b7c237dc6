// SPDX-License-Identifier: GPL-3.0-or-later
#include "phantoms/phantom.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include "limits/sinusoid.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/generated_pair.hpp"
#include "phantoms/phantom.hpp"

namespace impinge {
namespace {

constexpr double kHead = 22.0;    // mm
constexpr double kSocket = 26.0;  // mm
constexpr double kHalfOpening = 87.0 * kDegree;
constexpr double kConeHalfAngle = 25.0 * kDegree;
constexpr double kCylinderRadius = 12.0;  // mm
constexpr double kNeckEnd = 60.0;         // mm from the centre
constexpr double kStep = 10.0 * kDegree;  // between rings where nothing touches

std::string axis_name(const Vec3& axis) {
  const auto tilt = static_cast<int>(std::lround(std::asin(std::abs(axis.z())) / kDegree));
  return "limit about an axis " + std::to_string(tilt) + " degrees off the rim, degrees";
}

// Adds the limits of a joint about the axes of the questions.
void add_limits(const std::string& phantom, const TurnLimits& limits,
                const std::vector<AngleQuestion>& questions, std::vector<PhantomRow>& rows) {
  for (const AngleQuestion& question : questions) {
    const auto expected = first_turn_to(question);
    const TurnLimit limit = limits.first_contact(
        {Eigen::Matrix3d::Identity(), question.axis, Eigen::Matrix3d::Identity()}, 180.0);
    if (!expected || limit.state != LimitState::limited)
      throw std::logic_error("the phantom '" + phantom + "' has no limit");
    const double measured = 0.5 * (limit.low_deg + limit.high_deg);
    rows.push_back({phantom, axis_name(question.axis), *expected / kDegree, measured,
                    measured - *expected / kDegree, kPhantomLimitError, false});
  }
}

TriangleMesh cup_with_fine_rim(std::size_t sides) {
  std::vector<LatheRing> rings = sphere_rings(kSocket, kHalfOpening, kStep);
  rings.insert(rings.end() - 1, LatheRing{kHalfOpening - 0.1 * kDegree, kSocket});
  return revolve({rings, Vec3::UnitZ(), Vec3::Zero(), sides});
}

// A head, and a neck along -z through rings of these polar angles and radii, to an end cap.
TriangleMesh head_and_neck(const std::vector<LatheRing>& neck, std::size_t sides) {
  std::vector<LatheRing> rings = sphere_rings(kHead, kPi - neck.front().polar, kStep);
  for (LatheRing ring : neck) {
    ring.polar = kPi - ring.polar;
    rings.push_back(ring);
  }
  rings.push_back({kPi, neck.back().radius * std::cos(neck.back().polar)});
  return revolve({rings, Vec3::UnitZ(), Vec3::Zero(), sides});
}

// Axes across the neck, and tilted towards it: the neck then turns on a great circle, or on narrower ones.
std::array<Vec3, 3> axes() {
  const auto tilted = [](double degrees) {
    return Vec3(0.0, std::cos(degrees * kDegree), std::sin(degrees * kDegree));
  };
  return {tilted(0.0), tilted(20.0), tilted(35.0)};
}

// The questions of a neck that fills an angle about -z.
std::vector<AngleQuestion> neck_questions(double angle) {
  const Vec3 down = -Vec3::UnitZ();
  std::vector<AngleQuestion> questions;
  for (const Vec3& axis : axes())
    questions.push_back({down, down, axis, std::cos(kPi - kHalfOpening - angle)});
  return questions;
}

void add_necks(std::size_t sides, std::vector<PhantomRow>& rows) {
  const TriangleMesh socket = cup_with_fine_rim(sides);
  add_limits("cone neck", TurnLimits({head_and_neck({{kConeHalfAngle, kNeckEnd}}, sides), socket}),
             neck_questions(kConeHalfAngle), rows);
  std::vector<LatheRing> neck;
  for (const double radius : {kHead, 24.0, kSocket, 28.0, kNeckEnd})
    neck.push_back({std::asin(kCylinderRadius / radius), radius});
  add_limits("cylinder neck", TurnLimits({head_and_neck(neck, sides), socket}),
             neck_questions(std::asin(kCylinderRadius / kSocket)), rows);
}

// The bump of the generated pair; rings about its top are close together next to the level of the socket.
void add_bump(std::size_t sides, std::vector<PhantomRow>& rows) {
  const PairShape shape = impinging_cam();
  const double half_width = shape.cam_half_width_deg * kDegree;
  const double rise = shape.socket_radius - shape.head_radius;
  const double level = 2.0 * half_width / kPi * std::acos(std::sqrt(rise / shape.cam_height));
  constexpr double kClose = 0.002 * kDegree;
  std::vector<LatheRing> rings;
  const auto add = [&](double polar) {
    const double c = polar < half_width ? std::cos(0.5 * kPi * polar / half_width) : 0.0;
    rings.push_back({polar, shape.head_radius + shape.cam_height * c * c});
  };
  for (double polar = 0.0; polar < level - kClose; polar += kDegree) add(polar);
  for (const double beside : {-kClose, 0.0, kClose}) add(level + beside);
  for (double polar = level + kDegree; polar < half_width; polar += 2.0 * kDegree) add(polar);
  for (double polar = half_width; polar < kPi; polar += kStep) add(polar);
  add(kPi);
  const Vec3 top = cam_direction(shape);
  std::vector<AngleQuestion> questions;
  for (const Vec3& axis : axes())
    questions.push_back({top, Vec3::UnitZ(), -axis, std::cos(kHalfOpening + level)});
  add_limits("cam bump", TurnLimits({revolve({rings, top, Vec3::Zero(), sides}), cup_with_fine_rim(sides)}),
             questions, rows);
}

// Spheres about two points, with rings about the place where they touch.
void add_spheres(std::size_t sides, std::vector<PhantomRow>& rows) {
  constexpr double kBall = 20.0;
  constexpr double kSpace = kSocket - kBall;
  const Vec3 ball_centre(4.0, 0.0, 1.0);
  const Vec3 socket_centre(3.5, 0.0, -0.5);
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0.0, 0.6, 0.8)}) {
    const double product = ball_centre.norm() * socket_centre.norm();
    const double cosine =
        (ball_centre.squaredNorm() + socket_centre.squaredNorm() - kSpace * kSpace) / (2.0 * product);
    const AngleQuestion question{ball_centre.normalized(), socket_centre.normalized(), axis, cosine};
    const auto limit = first_turn_to(question);
    if (!limit) throw std::logic_error("the eccentric spheres never touch");
    const Eigen::AngleAxisd turn(*limit, axis);
    const Vec3 contact = (turn * ball_centre - socket_centre).normalized();
    add_limits("eccentric spheres",
               TurnLimits({revolve({focused_rings(kBall), turn.inverse() * contact, ball_centre, sides / 4}),
                           revolve({focused_rings(kSocket), contact, socket_centre, sides / 4})}),
               {question}, rows);
  }
}

}  // namespace

std::optional<double> first_turn_to(const AngleQuestion& question) {
  const double along = question.turning.dot(question.axis) * question.fixed.dot(question.axis);
  const double c = question.turning.dot(question.fixed) - along;
  const double d = question.axis.cross(question.turning).dot(question.fixed);
  const double height = std::hypot(c, d);
  const double share = (question.cosine - along) / height;
  if (!(std::abs(share) <= 1.0)) return std::nullopt;
  const double phase = std::atan2(d, c);
  const double off = std::acos(share);
  double first = 2.0 * kPi;
  for (const double t : {phase + off, phase - off}) {
    double turn = std::fmod(t, 2.0 * kPi);
    if (turn <= 0.0) turn += 2.0 * kPi;
    first = std::min(first, turn);
  }
  return first;
}

std::vector<PhantomRow> phantom_limits(const PhantomSizes& sizes) {
  std::vector<PhantomRow> rows;
  add_necks(sizes.sides, rows);
  add_bump(sizes.sides, rows);
  add_spheres(sizes.sides, rows);
  return rows;
}

}  // namespace impinge
