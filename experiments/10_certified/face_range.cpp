// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_certified/face_range.hpp"

#include <cmath>

namespace impinge::lab {
namespace {

constexpr double kLeastDepth = 0.05;  // of a corner along the axis, as a share of its distance
// A face whose plane is nearer to the centre than this share of what its corners allow has a radius that is
// not certain to ten digits: 1e10 times the rounding of its plane.
constexpr double kSteep = 1e10 * kPlaneTestError;

bool is_steep(const TriangleCone& cone) {
  const auto& [a, b, c] = cone.corners();
  const double largest = std::max({a.norm(), b.norm(), c.norm()});
  return !(cone.plane().offset > kSteep * cone.plane().size * largest);
}

DirectionCap cap_of(const TriangleCone& cone) {
  DirectionCap cap{Vec3::Zero(), 0.0};
  for (const Vec3& v : cone.corners()) cap.axis += v.normalized();
  cap.axis.normalize();
  for (const Vec3& v : cone.corners()) cap.radius = std::max(cap.radius, angle_between(cap.axis, v));
  return cap;
}

// No point of a triangle is nearer to the centre than its plane, which is not certain for a steep one, nor
// than its nearest corner less its longest side.
RadiusRange range_of(const TriangleCone& cone, bool steep) {
  RadiusRange whole;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    whole.include(cone.corners()[k].norm());
    longest = std::max(longest, (cone.corners()[(k + 1) % 3] - cone.corners()[k]).norm());
  }
  whole.low = std::max(whole.low - longest, steep ? 0.0 : cone.plane_distance());
  return whole;
}

// The part [from, to] of a segment y0 + t (y1 - y0), t in [0, 1], within a disc about the origin.
struct Stretch {
  double from = 0.0;
  double to = 1.0;
  bool empty = false;
};

Stretch within_disc(const Vec3& y0, const Vec3& y1, double radius) {
  const Vec3 d = y1 - y0;
  const double length = d.norm();
  if (length == 0.0) return {0.0, 1.0, y0.norm() > radius};
  const double nearest = -y0.dot(d) / (length * length);
  const double off = (y0 + nearest * d).norm();
  if (off > radius) return {0.0, 0.0, true};
  const double half = std::sqrt((radius - off) * (radius + off)) / length;
  const Stretch part{std::max(0.0, nearest - half), std::min(1.0, nearest + half), false};
  return {part.from, part.to, part.from > part.to};
}

}  // namespace

FaceRange::FaceRange(const TriangleCone& cone)
    : cone_(cone),
      normal_(cone.plane().normal.normalized()),
      own_(cap_of(cone)),
      steep_(is_steep(cone)),
      whole_(range_of(cone, steep_)) {}

std::optional<FaceInCap> FaceRange::in_cap(const DirectionCap& asked) const {
  const DirectionCap cap{asked.axis, asked.radius * (1.0 + kCapShare) + kCapSlack};
  const double reach = own_.radius + cap.radius + kCapSlack;
  // The directions of a face are within its cap where that is less than a quarter turn.
  const bool small = own_.radius < 0.5 * kPi;
  // By the chord: the cosine of a small angle has lost its digits.
  if (small && reach < kPi && (cap.axis - own_.axis).norm() > 2.0 * std::sin(0.5 * reach))
    return std::nullopt;
  bool deep = true;
  for (const Vec3& v : cone_.corners()) deep = deep && cap.axis.dot(v) > kLeastDepth * v.norm();
  FaceInCap part{whole_, {true, true, true}};
  if (deep && !steep_ && cap.radius < kWidestCap) {
    const double tangent = std::tan(cap.radius);
    part = {};
    include_edges(cap, tangent, part);
    include_inside(cap, tangent, part);
    if (part.range.empty()) return std::nullopt;
  }
  part.range.low *= 1.0 - kRangeSlack;
  part.range.high *= 1.0 + kRangeSlack;
  return part;
}

void FaceRange::include_edges(const DirectionCap& cap, double tangent, FaceInCap& part) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& a = cone_.corners()[k];
    const Vec3& b = cone_.corners()[(k + 1) % 3];
    const double depth_a = cap.axis.dot(a);
    const double depth_b = cap.axis.dot(b);
    const Stretch stretch = within_disc(a / depth_a - cap.axis, b / depth_b - cap.axis, tangent);
    part.side_inside[k] = !stretch.empty;
    if (stretch.empty) continue;
    // Central projection: t of the gnomonic plane is a share t / depth_b of (1 - t) / depth_a + t / depth_b.
    const auto share = [&](double t) { return t * depth_a / ((1.0 - t) * depth_b + t * depth_a); };
    const Vec3 along = b - a;
    const double from = share(stretch.from);
    const double to = share(stretch.to);
    const double length = along.squaredNorm();
    const double nearest = length > 0.0 ? std::clamp(-a.dot(along) / length, from, to) : from;
    for (const double s : {from, nearest, to}) part.range.include((a + s * along).norm());
  }
}

void FaceRange::include_inside(const DirectionCap& cap, double tangent, FaceInCap& part) const {
  const auto include = [&](const Vec3& x) {  // a point beside the face by no more than rounding does not harm
    const Vec3 u = x.normalized();
    if (cone_.least_edge_distance(u.x(), u.y(), u.z()) >= -cone_.doubt()) part.range.include(cone_.radius(u));
  };
  const double depth = cap.axis.dot(normal_);
  const Vec3 aside = normal_ - depth * cap.axis;
  const double off = aside.norm();
  const Vec3 way = off > 0.0 ? Vec3(aside / off) : cap.axis.unitOrthogonal();
  include(cap.axis + tangent * way);
  include(cap.axis - tangent * way);
  if (depth > 0.0 && off <= tangent * depth) include(normal_);
}

}  // namespace impinge::lab
