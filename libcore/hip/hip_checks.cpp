// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "files/formatted.hpp"
#include "hip/hip_parts.hpp"

namespace impinge {
namespace {

constexpr double kThickestNeck = 0.95;  // of the head's radius
constexpr double kThinnestNeck = 0.25;
constexpr double kLargestFillet = 0.33;  // of the head's radius
constexpr double kStraightNeck = 1.45;   // of the head's radius, from the centre
constexpr double kWidestRim = 140.0;     // degrees from the pole
constexpr double kNarrowestRim = 20.0;
constexpr int kRimSteps = 144;
constexpr int kPolarSteps = 48;

[[noreturn]] void refuse_hip(const char* pattern, auto... values) {
  throw std::invalid_argument(formatted(pattern, values...));
}

void require_neck(const HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  const double share = hip.neck_radius / hip.head_radius;
  if (!(share >= kThinnestNeck && share <= kThickestNeck)) {
    refuse_hip(
        "parameter head_neck_offset = %g leaves a neck of %.1f mm radius on a head of %.1f mm; give %.1f to "
        "%.1f mm",
        p.head_neck_offset, hip.neck_radius, hip.head_radius, (1.0 - kThickestNeck) * hip.head_radius,
        (1.0 - kThinnestNeck) * hip.head_radius);
  }
  if (p.neck_fillet > kLargestFillet * hip.head_radius) {
    refuse_hip("parameter neck_fillet = %g would round off the neck itself; give at most %.1f mm",
               p.neck_fillet, kLargestFillet * hip.head_radius);
  }
  const double missing = kStraightNeck * hip.head_radius - neck_end(hip);
  if (missing > 0.0) {
    refuse_hip("parameter neck_length = %g leaves no neck between head and shaft; give at least %.1f mm",
               p.neck_length, p.neck_length + missing);
  }
}

void require_conchoid(const HipParameters& p) {
  if ((p.conchoid_a > 0.0) != (p.conchoid_b > 0.0)) {
    refuse_hip("parameter conchoid_%s is 0 and the other is not; give both a and b, or neither",
               p.conchoid_a > 0.0 ? "b" : "a");
  }
  if (p.conchoid_b > 0.0 && !(p.conchoid_a > p.conchoid_b)) {
    refuse_hip(
        "parameter conchoid_a = %g is not above conchoid_b = %g, and the curve crosses itself; raise a",
        p.conchoid_a, p.conchoid_b);
  }
}

void require_rim(const HipSurface& hip) {
  for (int k = 0; k < kRimSteps; ++k) {
    const double hours = 12.0 * k / kRimSteps;
    const double polar = rim_polar(hip, hours) / kDegree;
    if (polar >= kNarrowestRim && polar <= kWidestRim) continue;
    const bool pincer = hip.parameters.pincer_height > 0.0 && polar > kWidestRim;
    refuse_hip(
        "parameter %s puts the rim %.0f degrees from the pole of the socket at %s o'clock, where %.0f to "
        "%.0f are possible; %s",
        pincer ? "pincer_height" : "lateral_centre_edge", polar, clock_text(hours).c_str(), kNarrowestRim,
        kWidestRim, pincer ? "lower it" : "give one nearer to half_opening minus inclination");
  }
}

struct RestGap {
  double gap = std::numeric_limits<double>::infinity();
  double hours = 0.0;
};

RestGap smallest_at_rest(const HipSurface& hip) {
  RestGap least;
  for (int k = 0; k < kRimSteps; ++k) {
    const double hours = 12.0 * k / kRimSteps;
    for (int i = 0; i <= kPolarSteps; ++i) {
      const double polar = rim_polar(hip, hours) * i / kPolarSteps;
      const Vec3 x =
          hip.socket_centre + hip.socket_radius * clock_direction(-hip.opening, hip.rim_clock, polar, hours);
      const double gap = x.norm() - head_neck_radius(hip, x.normalized());
      if (gap < least.gap) least = {gap, hours};
    }
  }
  return least;
}

// Distance of the ball with its parts, along a direction that meets the neck or one of the parts.
double ball_reach(const HipSurface& hip, const std::vector<BonePart>& parts, const Vec3& direction) {
  double reach = head_neck_radius(hip, direction);
  for (const BonePart& part : parts) reach = std::fmax(reach, part.farthest(direction));
  return reach;
}

bool within_rim(const HipSurface& hip, const Vec3& direction) {
  const Vec3 x = socket_radius(hip, direction) * direction - hip.socket_centre;
  return angle_between(x, -hip.opening) <= rim_polar(hip, hip.rim_clock.hours(x));
}

// Refuses a part of bone that meets the other bone at rest.
void require_free_parts(const HipSurface& hip) {
  constexpr double kStep = 2.0;  // mm between the points of a part that are tested
  const std::vector<BonePart> femur = femur_parts(hip);
  const std::vector<BonePart> acetabulum = acetabulum_parts(hip);
  const char* cure = "lower it, or move the part away";
  for (const BonePart& part : femur) {
    const bool greater = part.name == femur.front().name && hip.parameters.greater_trochanter_width > 0.0;
    for (const Vec3& x : mesh_of(part, kStep).vertices) {
      if (x.norm() < socket_radius(hip, x.normalized()) || !within_rim(hip, x.normalized())) continue;
      refuse_hip("parameter %s lets the %s touch the socket at rest; %s",
                 greater ? "greater_trochanter_width" : "lesser_trochanter_height", part.name.c_str(), cure);
    }
  }
  for (const BonePart& part : acetabulum) {
    for (const Vec3& x : mesh_of(part, kStep).vertices) {
      const Vec3 u = x.normalized();
      if (x.norm() > ball_reach(hip, femur, u)) continue;
      refuse_hip("parameter aiis_height = %g lets the %s touch the ball at rest; %s",
                 hip.parameters.aiis_height, part.name.c_str(), cure);
    }
  }
}

}  // namespace

void require_range(const HipParameters& parameters) {
  require_in_range(parameters);
  require_conchoid(parameters);
}

void require_shape(const HipSurface& hip) {
  require_neck(hip);
  require_rim(hip);
}

void require_free_at_rest(const HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  const RestGap rest = smallest_at_rest(hip);
  if (rest.gap > 0.0) return require_free_parts(hip);
  HipSurface without_cam = hip;
  without_cam.parameters.cam_height = 0.0;
  const bool cam = p.cam_height > 0.0 && smallest_at_rest(without_cam).gap > 0.0;
  refuse_hip(
      "parameter %s = %g lets the ball penetrate the socket by %.2f mm at rest, at %s o'clock; %s",
      cam ? "cam_height" : "joint_space", cam ? p.cam_height : p.joint_space, -rest.gap,
      clock_text(rest.hours).c_str(),
      cam ? "lower it, or move the cam from under the rim with cam_polar or cam_half_width"
          : "raise it, or lower what brings the surfaces together: shifts, half_opening, pincer_height");
}

}  // namespace impinge
