// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "hip/hip_rings.hpp"

namespace impinge {
namespace {

constexpr double kFine = 0.7;                  // times the spacing, where head and neck meet
constexpr double kCoarse = 1.8;                // times the spacing, along the shaft
constexpr double kFineUpTo = 100.0 * kDegree;  // from the neck axis: cams end there
constexpr double kProfileStep = 0.05 * kDegree;

// A cross-section is a circle or ring about `middle` in the plane of the two unit vectors.
struct Section {
  Vec3 middle;
  Vec3 first;
  Vec3 second;
};

// The plane of neck and shaft. `inward` is perpendicular to the neck, on the side to which it bends.
struct Frame {
  Vec3 neck;
  Vec3 inward;
  Vec3 hinge;
};

Frame frame_of(const HipSurface& hip) {
  const Vec3 down = -Vec3::UnitZ();
  const Vec3 inward = (down - down.dot(hip.neck) * hip.neck).normalized();
  return {hip.neck, inward, hip.neck.cross(inward)};
}

std::size_t ring_size(double radius, double spacing) {
  return static_cast<std::size_t>(std::max(6L, std::lround(2.0 * kPi * radius / spacing)));
}

// Azimuth of point k of n; every second ring is turned by half a step.
double azimuth(std::size_t k, std::size_t n, bool turned) {
  return 2.0 * kPi * (static_cast<double>(k) + (turned ? 0.5 : 0.0)) / static_cast<double>(n);
}

double spacing_at(double polar, double spacing) { return polar < kFineUpTo ? kFine * spacing : spacing; }

// Angles from the neck axis at which rings of the given spacing stand on head and neck, without the pole.
std::vector<double> ring_polars(const HipSurface& hip, double spacing) {
  const double last = std::atan2(hip.neck_radius, neck_end(hip));
  const auto steps = static_cast<std::size_t>(std::ceil((kPi - last) / kProfileStep));
  std::vector<double> polar(steps + 1);
  std::vector<double> rings(steps + 1, 0.0);  // number of rings up to there
  for (std::size_t i = 0; i <= steps; ++i)
    polar[i] = kPi + (last - kPi) * static_cast<double>(i) / static_cast<double>(steps);
  for (std::size_t i = 1; i <= steps; ++i) {
    const double before = plain_head_neck_radius(hip, polar[i - 1]);
    const double here = plain_head_neck_radius(hip, polar[i]);
    const double length = std::hypot(here - before, 0.5 * (here + before) * (polar[i] - polar[i - 1]));
    rings[i] = rings[i - 1] + length / (kBandHeight * spacing_at(polar[i], spacing));
  }
  const auto count = static_cast<std::size_t>(std::max(4L, std::lround(rings.back())));
  std::vector<double> chosen;
  for (std::size_t k = 1; k < count; ++k) {
    const double wanted = rings.back() * static_cast<double>(k) / static_cast<double>(count);
    chosen.push_back(
        polar[static_cast<std::size_t>(std::ranges::lower_bound(rings, wanted) - rings.begin())]);
  }
  chosen.push_back(last);
  return chosen;
}

void append_head_and_neck(PointRings& rings, const HipSurface& hip, double spacing) {
  const Frame frame = frame_of(hip);
  rings.push_back({-head_neck_radius(hip, -hip.neck) * hip.neck});
  for (const double polar : ring_polars(hip, spacing)) {
    const double radius = plain_head_neck_radius(hip, polar) * std::sin(polar);
    const std::size_t n = ring_size(radius, spacing_at(polar, spacing));
    std::vector<Vec3>& ring = rings.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      const double turn = azimuth(k, n, rings.size() % 2 != 0);
      const Vec3 u = std::cos(polar) * frame.neck +
                     std::sin(polar) * (std::cos(turn) * frame.inward + std::sin(turn) * frame.hinge);
      ring.push_back(head_neck_radius(hip, u) * u);
    }
  }
}

void append_circle(PointRings& rings, const Section& at, double radius, std::size_t n) {
  std::vector<Vec3> ring;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = azimuth(k, n, rings.size() % 2 == 0);
    ring.push_back(at.middle + radius * (std::cos(turn) * at.first + std::sin(turn) * at.second));
  }
  rings.push_back(std::move(ring));
}

long steps_over(double length, double spacing) {
  return std::max(1L, std::lround(length / (kBandHeight * spacing)));
}

// The section after a bend by `angle`; its middle is on the arc.
Section bent_section(const HipSurface& hip, double angle) {
  const Frame frame = frame_of(hip);
  const Vec3 pivot = neck_end(hip) * frame.neck + hip.bend_radius * frame.inward;
  const Vec3 arm = std::cos(angle) * frame.inward - std::sin(angle) * frame.neck;
  return {pivot - hip.bend_radius * arm, arm, frame.hinge};
}

void append_bend(PointRings& rings, const HipSurface& hip, double spacing) {
  const HipParameters& p = hip.parameters;
  const double bend = kPi - p.neck_shaft_angle * kDegree;
  const long steps = steps_over(bend * (hip.bend_radius + 0.5 * p.shaft_radius), spacing);
  for (long k = 1; k <= steps; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(steps);
    const double radius = hip.neck_radius + (p.shaft_radius - hip.neck_radius) * t * t * (3.0 - 2.0 * t);
    append_circle(rings, bent_section(hip, t * bend), radius, ring_size(radius, spacing));
  }
}

// The shaft below the bend, and its flat end.
void append_shaft(PointRings& rings, const HipSurface& hip, double spacing) {
  const HipParameters& p = hip.parameters;
  Section at = bent_section(hip, kPi - p.neck_shaft_angle * kDegree);
  const Vec3 top = at.middle;
  const long steps = steps_over(p.shaft_length, spacing);
  for (long k = 1; k <= steps; ++k) {
    at.middle = top - p.shaft_length * static_cast<double>(k) / static_cast<double>(steps) * Vec3::UnitZ();
    append_circle(rings, at, p.shaft_radius, ring_size(p.shaft_radius, spacing));
  }
  const long across = steps_over(p.shaft_radius, spacing);
  for (long k = across - 1; k > 0; --k) {
    const double radius = p.shaft_radius * static_cast<double>(k) / static_cast<double>(across);
    append_circle(rings, at, radius, ring_size(radius, spacing));
  }
  rings.push_back({at.middle});
}

// A half ball on the end of the neck.
void append_dome(PointRings& rings, const HipSurface& hip, double spacing) {
  const Frame frame = frame_of(hip);
  const double r = hip.neck_radius;
  const long steps = steps_over(0.5 * kPi * r, spacing);
  for (long k = 1; k < steps; ++k) {
    const double angle = 0.5 * kPi * static_cast<double>(k) / static_cast<double>(steps);
    const Section at{(neck_end(hip) + r * std::sin(angle)) * frame.neck, frame.inward, frame.hinge};
    append_circle(rings, at, r * std::cos(angle), ring_size(r * std::cos(angle), spacing));
  }
  rings.push_back({(neck_end(hip) + r) * frame.neck});
}

}  // namespace

PointRings femur_rings(const HipSurface& hip, double spacing) {
  PointRings rings;
  append_head_and_neck(rings, hip, spacing);
  if (hip.parameters.shaft_length == 0.0) {
    append_dome(rings, hip, spacing);
    return rings;
  }
  append_bend(rings, hip, kCoarse * spacing);
  append_shaft(rings, hip, kCoarse * spacing);
  return rings;
}

}  // namespace impinge
