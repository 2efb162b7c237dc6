// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_surface.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "hip/hip_checks.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/bodies.hpp"

namespace impinge {
namespace {

constexpr double kHour = kPi / 6.0;    // of a clock, radians
constexpr double kLateralHours = 2.0;  // to either side, over which the rim is raised to the CE angle
constexpr double kBendShare = 1.3;     // bend radius divided by the radius of what is bent
constexpr double kHighestAlpha = 2.0;  // radians; where the search for the alpha angle begins
constexpr double kAlphaStep = 0.25 * kDegree;
constexpr int kBisections = 60;

// 1 in the middle, 0 at t = 1 and beyond, with a continuous slope.
double bump(double t) {
  if (std::abs(t) >= 1.0) return 0.0;
  const double c = std::cos(0.5 * kPi * t);
  return c * c;
}

double hours_apart(double a, double b) { return std::remainder(a - b, 12.0); }

// The larger of the two. Where they differ by less than `reach` the edge is rounded, by at most reach / 4.
double smooth_max(double a, double b, double reach) {
  const double apart = std::abs(a - b);
  if (apart >= reach) return std::max(a, b);
  const double share = 1.0 - apart / reach;
  return std::max(a, b) + 0.25 * reach * share * share;
}

// A point of the conchoid r = a + b cos(phi), relative to its origin: along the axis, and away from it.
struct ProfilePoint {
  double along;
  double away;
};
ProfilePoint conchoid_point(const HipParameters& p, double phi) {
  const double r = p.conchoid_a + p.conchoid_b * std::cos(phi);
  return {r * std::cos(phi), r * std::sin(phi)};
}

bool is_conchoid(const HipParameters& p) { return p.conchoid_a > 0.0 && p.conchoid_b > 0.0; }

// The sphere that fits the conchoid best over phi <= 90 degrees, with equal weight on all of its surface.
SphereFit fit_conchoid(const HipParameters& p) {
  constexpr int kSteps = 90;
  constexpr int kTurns = 8;
  std::vector<Vec3> points;
  std::vector<double> weight;
  for (int i = 0; i < kSteps; ++i) {
    const double phi = (i + 0.5) * 0.5 * kPi / kSteps;
    const ProfilePoint q = conchoid_point(p, phi);
    const double slope = p.conchoid_b * std::sin(phi);
    for (int k = 0; k < kTurns; ++k) {
      const double turn = 2.0 * kPi * k / kTurns;
      points.emplace_back(q.away * std::cos(turn), q.away * std::sin(turn), q.along);
      weight.push_back(q.away * std::hypot(slope, std::hypot(q.along, q.away)));
    }
  }
  return fit_sphere(points, weight);
}

// Distance of the conchoid at `polar` from its axis, seen from a point on the axis `origin` ahead of its own.
double conchoid_radius(const HipParameters& p, double origin, double polar) {
  double low = 0.0;
  double high = kPi;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (low + high);
    const ProfilePoint q = conchoid_point(p, middle);
    (std::atan2(q.away, q.along - origin) < polar ? low : high) = middle;
  }
  const ProfilePoint q = conchoid_point(p, 0.5 * (low + high));
  return std::hypot(q.along - origin, q.away);
}

// Distance of the head without a cam at `polar` from the neck axis.
double plain_head_radius(const HipSurface& hip, double polar) {
  const HipParameters& p = hip.parameters;
  if (is_conchoid(p)) return conchoid_radius(p, hip.conchoid_origin, kPi - polar);
  if (p.head_axis_ratio == 1.0) return p.head_radius;
  return p.head_radius / std::hypot(std::sin(polar), std::cos(polar) / p.head_axis_ratio);
}

double with_neck(const HipSurface& hip, double head, double polar) {
  if (polar >= 0.5 * kPi) return head;
  return smooth_max(head, hip.neck_radius / std::sin(polar), hip.parameters.neck_fillet);
}

double pincer_polar(const HipSurface& hip, double hours) {
  const HipParameters& p = hip.parameters;
  return p.pincer_height / hip.socket_radius * bump(hours_apart(hours, p.pincer_clock) / p.pincer_half_width);
}

void place_femur(HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  const double ccd = p.neck_shaft_angle * kDegree;
  const double torsion = p.femoral_torsion * kDegree;
  hip.neck = Vec3(std::sin(ccd) * std::cos(torsion), -std::sin(ccd) * std::sin(torsion), std::cos(ccd));
  hip.neck_clock = clock_about(hip.neck).value();
  hip.head_radius = p.head_radius;
  if (is_conchoid(p)) {
    const SphereFit fit = fit_conchoid(p);
    hip.head_radius = fit.radius;
    hip.conchoid_origin = fit.centre.z();
  }
  hip.neck_radius = hip.head_radius - p.head_neck_offset;
  hip.bend_radius = kBendShare * std::max(hip.neck_radius, p.shaft_radius);
}

void place_socket(HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  hip.opening =
      Vec3(1.0, std::tan(p.version * kDegree), -1.0 / std::tan(p.inclination * kDegree)).normalized();
  hip.rim_clock = clock_about(hip.opening).value();
  hip.socket_radius = hip.head_radius + p.joint_space;
  hip.socket_centre = Vec3(p.shift_lateral, p.shift_anterior, p.shift_superior);
  const double edge = p.lateral_centre_edge * kDegree;
  const Vec3 lateral(std::sin(edge), 0.0, std::cos(edge));
  const Vec3 rim =
      eccentric_sphere_radius(lateral, hip.socket_radius, hip.socket_centre) * lateral - hip.socket_centre;
  hip.lateral_clock = hip.rim_clock.hours(rim);
  hip.lateral_raise =
      angle_between(rim, -hip.opening) - p.half_opening * kDegree - pincer_polar(hip, hip.lateral_clock);
}

}  // namespace

HipSurface hip_surface(const HipParameters& parameters) {
  require_range(parameters);
  HipSurface hip;
  hip.parameters = parameters;
  place_femur(hip);
  place_socket(hip);
  require_shape(hip);
  return hip;
}

Vec3 clock_direction(const Vec3& axis, const ClockFace& clock, double polar, double hours) {
  return std::cos(polar) * axis +
         std::sin(polar) * (std::cos(hours * kHour) * clock.twelve + std::sin(hours * kHour) * clock.three);
}

double head_radius(const HipSurface& hip, const Vec3& direction) {
  const HipParameters& p = hip.parameters;
  const Vec3 top = clock_direction(hip.neck, hip.neck_clock, p.cam_polar * kDegree, p.cam_clock);
  return plain_head_radius(hip, angle_between(direction, hip.neck)) +
         p.cam_height * bump(angle_between(direction, top) / (p.cam_half_width * kDegree));
}

double head_neck_radius(const HipSurface& hip, const Vec3& direction) {
  return with_neck(hip, head_radius(hip, direction), angle_between(direction, hip.neck));
}

double neck_end(const HipSurface& hip) {
  const double bend = kPi - hip.parameters.neck_shaft_angle * kDegree;
  return hip.parameters.neck_length - hip.bend_radius * std::tan(0.5 * bend);
}

double plain_head_neck_radius(const HipSurface& hip, double polar) {
  return with_neck(hip, plain_head_radius(hip, polar), polar);
}

double inner_radius(const HipSurface& hip, const Vec3& from_socket_centre) {
  const HipParameters& p = hip.parameters;
  const Vec3 fossa = clock_direction(-hip.opening, hip.rim_clock, p.fossa_polar * kDegree, 6.0);
  return hip.socket_radius +
         p.fossa_depth * bump(angle_between(from_socket_centre, fossa) / (p.fossa_half_width * kDegree));
}

// |t u - c| = R + fossa in that direction, by fixed-point iteration: the fossa is much flatter than a ray.
double socket_radius(const HipSurface& hip, const Vec3& direction) {
  constexpr int kMostRounds = 50;
  double t = eccentric_sphere_radius(direction, hip.socket_radius, hip.socket_centre);
  for (int k = 0; k < kMostRounds; ++k) {
    const double radius = inner_radius(hip, t * direction - hip.socket_centre);
    const double next = eccentric_sphere_radius(direction, radius, hip.socket_centre);
    if (next == t) break;
    t = next;
  }
  return t;
}

double rim_polar(const HipSurface& hip, double hours) {
  return hip.parameters.half_opening * kDegree + pincer_polar(hip, hours) +
         hip.lateral_raise * bump(hours_apart(hours, hip.lateral_clock) / kLateralHours);
}

double alpha_angle_deg(const HipSurface& hip, double hours) {
  const double limit = (1.0 + kAlphaShare) * hip.head_radius;
  const auto beyond = [&](double polar) {
    return head_neck_radius(hip, clock_direction(hip.neck, hip.neck_clock, polar, hours)) > limit;
  };
  double polar = kHighestAlpha;
  while (!beyond(polar)) polar -= kAlphaStep;
  double outside = polar;
  double inside = polar + kAlphaStep;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (inside + outside);
    (beyond(middle) ? outside : inside) = middle;
  }
  return outside / kDegree;
}

}  // namespace impinge
