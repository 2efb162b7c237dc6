// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "hip/hip_measures.hpp"
#include "hip/hip_surface.hpp"
#include "mesh/sphere_section.hpp"

namespace impinge {
namespace {

constexpr double kShaftStart = 1.45;  // the same: no shaft is nearer
constexpr double kShaftEnd = 6.0;     // the same, down the shaft: a whole femur widens to the knee beyond
constexpr double kBridge = 20.0;      // degrees of the head between neck and cam
constexpr int kSectors = 24;          // about the neck, all of which its section has to meet
constexpr double kEndFace = 0.5;      // cosine between normal and axis; above, a face belongs to the cut
constexpr double kRound = 0.05;       // least over middle eigenvalue of normals round a shaft
constexpr int kShaftSteps = 20;
constexpr int kBeside = 8;  // crossings to either side of a clock position

Vec3 mirrored(const Vec3& x, Side side) { return side == Side::left ? Vec3(-x.x(), x.y(), x.z()) : x; }

// The same mesh as a right one, with the head's centre as origin.
TriangleMesh as_right(TriangleMesh mesh, const Vec3& centre, Side side) {
  for (Vec3& v : mesh.vertices) v = mirrored(v - centre, side);
  if (side == Side::left) {
    for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  }
  return mesh;
}

// Mean of a function of the points of a curve, by length.
template <class F>
auto mean_over(const std::vector<Segment>& curve, const F& f) {
  auto sum = f(curve.front()[0]);
  sum *= 0.0;
  double total = 0.0;
  for (const Segment& s : curve) {
    const double length = (s[1] - s[0]).norm();
    sum += 0.5 * length * (f(s[0]) + f(s[1]));
    total += length;
  }
  sum /= total;
  return sum;
}

// Does a curve meet every sector about an axis?
bool goes_round(const std::vector<Segment>& curve, const Vec3& axis) {
  const Vec3 across = axis.unitOrthogonal();
  const Vec3 third = axis.cross(across);
  std::array<bool, kSectors> met{};
  for (const Segment& s : curve) {
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {  // a coarse mesh has long ones
      const Vec3 x = s[0] + share * (s[1] - s[0]);
      const double turn = std::atan2(x.dot(third), x.dot(across)) / (2.0 * kPi) + 0.5;
      met[std::min(static_cast<std::size_t>(turn * kSectors), met.size() - 1)] = true;
    }
  }
  return std::ranges::all_of(met, [](bool m) { return m; });
}

// Angle from the axis, degrees, at which a surface that is off the head at the axis last comes back to it, at
// these hours: `curve` is where it crosses. What stands off farther than kBridge from there is no part of the
// neck or its cam.
double last_crossing(const std::vector<Segment>& curve, const Vec3& axis, const Vec3& outward) {
  const Vec3 across = axis.cross(outward);
  std::vector<double> crossings;
  for (const Segment& s : curve) {
    const double from = s[0].dot(across);
    const double to = s[1].dot(across);
    if ((from < 0.0) == (to < 0.0)) continue;
    const Vec3 x = s[0] + from / (from - to) * (s[1] - s[0]);
    if (x.dot(outward) > 0.0) crossings.push_back(angle_between(x, axis) / kDegree);
  }
  std::ranges::sort(crossings);
  if (crossings.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::size_t last = 0;
  while (last + 2 < crossings.size() && crossings[last + 1] - crossings[last] < kBridge) last += 2;
  return crossings[last];
}

// The median of those about a clock position, which noise of single vertices hardly moves.
double steady_crossing(const std::vector<Segment>& curve, const Vec3& axis, const ClockFace& clock,
                       double hours, double window) {
  std::vector<double> found;
  for (int k = -kBeside; k <= kBeside; ++k) {
    const Vec3 outward = clock_direction(axis, clock, 0.5 * kPi, hours + window * k / kBeside);
    if (const double angle = last_crossing(curve, axis, outward); !std::isnan(angle)) found.push_back(angle);
  }
  if (found.size() <= kBeside) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(found);
  return found[found.size() / 2];
}

// Direction square to the normals of the straight lower end of the shaft, pointing down it.
std::optional<Vec3> shaft_axis(const TriangleMesh& mesh, double head_radius, double share) {
  Vec3 axis = *std::ranges::max_element(mesh.vertices, {}, [](const Vec3& v) { return v.squaredNorm(); });
  const double beyond = std::min(axis.norm(), kShaftEnd * head_radius) - kShaftStart * head_radius;
  if (!(beyond > 0.0)) return std::nullopt;
  axis.normalize();
  Vec3 spread = Vec3::Zero();
  for (int k = 0; k < kShaftSteps; ++k) {
    double end = 0.0;
    for (const Vec3& v : mesh.vertices) end = std::max(end, v.dot(axis));
    end = std::min(end, kShaftEnd * head_radius);
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (const Face& face : mesh.faces) {
      const Vec3 middle = (corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2)) / 3.0;
      const Vec3 area = area_vector(mesh, face);
      if (middle.dot(axis) < end - share * beyond || middle.dot(axis) > end) continue;
      if (std::abs(area.dot(axis)) > kEndFace * area.norm()) continue;
      normals += area * area.transpose() / area.norm();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
    const Vec3 next = solver.eigenvectors().col(0);
    spread = solver.eigenvalues();
    axis = next.dot(axis) < 0.0 ? Vec3(-next) : next;
  }
  if (!(spread[0] < kRound * spread[1])) return std::nullopt;
  return axis;
}

// Angle of the neck from the transverse axis, in the plane square to the shaft.
double torsion_deg(const Vec3& neck, const Vec3& shaft) {
  const Vec3 lateral = (Vec3::UnitX() - shaft.x() * shaft).normalized();
  const Vec3 anterior = lateral.cross(shaft);
  return std::atan2(-neck.dot(anterior), neck.dot(lateral)) / kDegree;
}

}  // namespace

Vec3 neck_axis(const std::vector<Segment>& section) {
  return mean_over(section, [](const Vec3& x) { return x; }).normalized();
}

FemurMeasures measure_femur(const TriangleMesh& ball, Side side, const MeasureChoices& choices) {
  FemurMeasures found;
  BallFitOptions fit;
  fit.trim = choices.trim;
  found.head = fit_ball(ball, fit);
  const double radius = found.head.radius;
  const TriangleMesh right = as_right(ball, found.head.centre, side);
  const std::vector<Segment> section = sphere_section(right, choices.neck_section * radius);
  if (section.empty()) {
    throw std::invalid_argument("the ball has no neck to measure; give a mesh that reaches 1.35 head radii");
  }
  const Vec3 neck = neck_axis(section);
  if (!goes_round(section, neck))
    throw std::invalid_argument(
        "the ball's mesh ends at the neck; give one that has all of its section at 1.35 head radii");
  found.neck_axis = mirrored(neck, side);
  found.neck_radius = mean_over(section, [&neck](const Vec3& x) { return x.cross(neck).norm(); });
  found.head_neck_offset = radius - found.neck_radius;
  if (const auto clock = clock_about(neck)) {
    const std::vector<Segment> contour = sphere_section(right, (1.0 + choices.alpha_share) * radius);
    const auto alpha_at = [&](double hours) {
      return steady_crossing(contour, neck, *clock, hours, choices.alpha_window);
    };
    for (std::size_t h = 0; h < kClockHours; ++h) found.alpha[h] = alpha_at(static_cast<double>(h));
    found.alpha_at_1_30 = alpha_at(1.5);
  }
  if (const auto shaft = shaft_axis(right, radius, choices.shaft_share)) {
    found.neck_shaft_angle = 180.0 - angle_between(neck, *shaft) / kDegree;
    found.femoral_torsion = torsion_deg(neck, *shaft);
  }
  return found;
}

}  // namespace impinge
