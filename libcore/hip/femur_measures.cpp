// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "hip/hip_measures.hpp"
#include "hip/hip_surface.hpp"
#include "mesh/sphere_section.hpp"

namespace impinge {
namespace {

constexpr double kShaftStart = 1.45;  // head radii from the centre: no shaft is nearer
constexpr double kShaftEnd = 6.0;     // head radii down the shaft: a whole femur widens to the knee beyond
constexpr double kBridge = 20.0;      // degrees of the head between neck and cam
constexpr int kSectors = 24;          // about the neck, all of which its section has to meet
constexpr double kEndFace = 0.5;      // cosine between normal and axis; above, a face belongs to the cut
constexpr double kRound = 0.05;       // least over middle eigenvalue of normals round a shaft
constexpr int kShaftSteps = 20;
constexpr int kCircleSteps = 20;
constexpr double kScales = 2.5;
constexpr double kFlat = 0.002;       // of the radius, by which a coarse contour is off its circle
constexpr double kCircleRank = 1e-6;  // least reciprocal condition: an arc too short has no circle
constexpr int kBeside = 8;            // crossings to either side of a clock position

Vec3 mirrored(const Vec3& x, Side side) { return side == Side::left ? Vec3(-x.x(), x.y(), x.z()) : x; }

// The mesh mirrored to a right one where it is left, with the head's centre as origin.
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
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {  // a coarse mesh has long edges
      const Vec3 x = s[0] + share * (s[1] - s[0]);
      const double turn = std::atan2(x.dot(third), x.dot(across)) / (2.0 * kPi) + 0.5;
      met[std::min(static_cast<std::size_t>(turn * kSectors), met.size() - 1)] = true;
    }
  }
  return std::ranges::all_of(met, [](bool m) { return m; });
}

// The last angle from the axis, degrees, at which a surface crosses the head, if it is off the head at the
// axis. What stands off more than kBridge farther out is no part of the neck or its cam.
double last_of(std::vector<double> crossings) {
  std::ranges::sort(crossings);
  if (crossings.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::size_t last = 0;
  while (last + 2 < crossings.size() && crossings[last + 1] - crossings[last] < kBridge) last += 2;
  return crossings[last];
}

// The last crossing in the direction `outward`; `curve` is where the surface crosses the head.
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
  return last_of(std::move(crossings));
}

// The median of the last crossings about a clock position; noise of single vertices hardly moves it.
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

// Where a mesh crosses the plane through the origin with this normal.
std::vector<Segment> plane_section(const TriangleMesh& mesh, const Vec3& normal) {
  std::vector<Segment> section;
  for (const Face& face : mesh.faces) {
    std::vector<Vec3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = corner(mesh, face, k);
      const Vec3& b = corner(mesh, face, (k + 1) % 3);
      const double from = a.dot(normal);
      const double to = b.dot(normal);
      if ((from < 0.0) != (to < 0.0)) ends.emplace_back(a + from / (from - to) * (b - a));
    }
    if (ends.size() == 2) section.push_back({ends[0], ends[1]});
  }
  return section;
}

// Centre and radius of the circle in the plane of x and y that fits a contour by least squares. It begins
// with a circle about the origin. As in fit_ball(), points that are off it by more than `trim` or by kScales
// standard deviations do not count; the neck hardly changes these.
std::optional<std::pair<Vec3, double>> fit_circle(const std::vector<Segment>& contour, double radius,
                                                  double trim, const Vec3& x, const Vec3& y) {
  Vec3 centre = Vec3::Zero();
  for (int k = 0; k < kCircleSteps; ++k) {
    std::vector<double> near;
    const auto off = [&](const Segment& s) { return (0.5 * (s[0] + s[1]) - centre).norm() - radius; };
    for (const Segment& s : contour)
      if (std::abs(off(s)) <= trim * radius) near.push_back(std::abs(off(s)));
    if (near.empty()) return std::nullopt;
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::nth_element(near.begin(), middle, near.end());
    const double most = std::min(trim * radius, kScales * 1.4826 * *middle + kFlat * radius);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();
    for (const Segment& s : contour) {
      if (!(std::abs(off(s)) <= most)) continue;
      const Vec3 out = (0.5 * (s[0] + s[1]) - centre).normalized();
      const Vec3 row(out.dot(x), out.dot(y), 1.0);
      const double length = (s[1] - s[0]).norm();
      normal += length * row * row.transpose();
      right += length * off(s) * row;
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (!solver.isPositive() || !(solver.rcond() > kCircleRank)) return std::nullopt;
    const Vec3 step = solver.solve(right);
    centre += step[0] * x + step[1] * y;
    radius += step[2];
  }
  return std::pair(centre, radius);
}

// Alpha as Notzli et al. 2002 draw it, in the plane of the neck's axis and the anterior direction. A circle
// is fitted to the head's contour; the angle is from the line through its centre and the middle of the neck
// to where the contour last leaves the circle. NaN where it does not leave it.
double notzli_alpha(const TriangleMesh& mesh, const Vec3& middle_of_neck, const Vec3& anterior, double radius,
                    const MeasureChoices& choices) {
  const Vec3 x = middle_of_neck.normalized();
  const Vec3 y = (anterior - anterior.dot(x) * x).normalized();
  const std::vector<Segment> contour = plane_section(mesh, x.cross(y));
  const auto circle = fit_circle(contour, radius, choices.trim, x, y);
  if (!circle) return std::numeric_limits<double>::quiet_NaN();
  const auto& [centre, fitted] = *circle;
  const Vec3 axis = (middle_of_neck - centre).normalized();
  const double left = (1.0 + choices.alpha_share) * fitted;
  std::vector<double> crossings;
  for (const Segment& s : contour) {
    const Vec3 a = s[0] - centre;
    const Vec3 b = s[1] - centre;
    const double from = a.norm() - left;
    const double to = b.norm() - left;
    if ((from < 0.0) == (to < 0.0)) continue;
    const Vec3 left_at = a + from / (from - to) * (b - a);
    if (left_at.dot(y) > 0.0) crossings.push_back(angle_between(left_at, axis) / kDegree);
  }
  return last_of(std::move(crossings));
}

// Unit vector down the shaft, perpendicular to the normals of its straight lower end.
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

// Angle of the neck from the transverse axis, in the plane perpendicular to the shaft.
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
    const Vec3 middle = mean_over(section, [](const Vec3& x) { return x; });
    found.alpha_notzli =
        notzli_alpha(right, middle, clock_direction(neck, *clock, 0.5 * kPi, 3.0), radius, choices);
  }
  if (const auto shaft = shaft_axis(right, radius, choices.shaft_share)) {
    found.neck_shaft_angle = 180.0 - angle_between(neck, *shaft) / kDegree;
    found.femoral_torsion = torsion_deg(neck, *shaft);
  }
  return found;
}

}  // namespace impinge
