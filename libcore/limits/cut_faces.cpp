// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/cut_faces.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr double kRounding = 1e-12;  // share of the largest coordinate, above the rounding of doubles here

CutRange radius_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const auto [least, most] = std::minmax({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  return {std::sqrt(std::max(0.0, least - longest / 3.0)), std::sqrt(most)};
}

// Adds where the arc takes a point: its places at both ends, and where the tangents of its circle there meet.
struct ArcEnds {
  ArcEnds(const CutMotion& motion, const CutArc& arc)
      : from(at(motion, arc.from)),
        to(at(motion, arc.to)),
        axis(motion.outer * motion.axis),
        shift(motion.shift) {
    const double cosine = std::cos(0.5 * arc.degrees() * kDegree);
    outwards = 0.5 / (cosine * cosine);
  }
  static Eigen::Matrix3d at(const CutMotion& motion, const HalfAngle& half) {
    return motion.outer * Eigen::AngleAxisd(degrees_of(half) * kDegree, motion.axis).toRotationMatrix() *
           motion.inner;
  }
  void add(const Vec3& x, bool moves, std::vector<Vec3>& points) const {
    const Vec3 a = from * x;
    points.push_back(a + shift);
    if (!moves) return;
    const Vec3 b = to * x;
    const Vec3 on_axis = axis.dot(a) * axis;
    points.push_back(b + shift);
    points.push_back(on_axis + outwards * (a + b - 2.0 * on_axis) + shift);
  }
  Eigen::Matrix3d from;
  Eigen::Matrix3d to;
  Vec3 axis;
  Vec3 shift;
  double outwards;
};

}  // namespace

CutRange CutFaces::along(std::uint32_t k, const Vec3& direction) const {
  CutRange range{kInfinity, -kInfinity};
  for (const Vec3& x : of(k)) {
    const double d = direction.dot(x);
    range.low = std::min(range.low, d);
    range.high = std::max(range.high, d);
  }
  return range;
}

CutFaces ball_faces(const UncertainMesh& ball, std::span<const std::uint32_t> faces, const CutMotion& motion,
                    const CutArc& arc) {
  const ArcEnds ends(motion, arc);
  CutFaces found;
  found.each = arc.moves() ? 9 : 3;
  found.face.assign(faces.begin(), faces.end());
  double largest = motion.shift.norm();
  for (const std::uint32_t f : faces) {
    const auto corners = corners_of(ball.mesh, ball.mesh.faces[f]);
    for (const Vec3& x : corners) ends.add(x, arc.moves(), found.points);
    const CutRange radius = radius_of(corners[0], corners[1], corners[2]);
    largest = std::max(largest, radius.high);
    if (motion.shift.isZero(0.0)) found.radius.push_back(radius);
  }
  const double out = std::max(1.0, 2.0 * ends.outwards);
  found.off = out * (ball.off_mm + kRounding * largest);
  return found;
}

CutFaces socket_faces(const UncertainMesh& socket) {
  std::vector<std::uint32_t> all(socket.mesh.faces.size());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<std::uint32_t>(f);
  return ball_faces(socket, all, {}, {});
}

CutGap widest_gap(std::span<const Vec3> a, std::span<const Vec3> b) {
  CutGap best{Vec3::UnitX(), -kInfinity};
  const auto try_direction = [&](const Vec3& direction) {
    if (!(direction.squaredNorm() > 0.0)) return;
    const Vec3 unit = direction.normalized();
    const auto [a_low, a_high] = std::minmax({unit.dot(a[0]), unit.dot(a[1]), unit.dot(a[2])});
    const auto [b_low, b_high] = std::minmax({unit.dot(b[0]), unit.dot(b[1]), unit.dot(b[2])});
    const double gap = std::max(b_low - a_high, a_low - b_high);
    if (gap > best.mm) best = {unit, gap};
  };
  const Vec3 across_a = (a[1] - a[0]).cross(a[2] - a[0]);
  const Vec3 across_b = (b[1] - b[0]).cross(b[2] - b[0]);
  try_direction(across_a);
  try_direction(across_b);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = a[(i + 1) % 3] - a[i];
    try_direction(side.cross(across_a));
    try_direction((b[(i + 1) % 3] - b[i]).cross(across_b));
    for (std::size_t j = 0; j < 3; ++j) try_direction(side.cross(b[(j + 1) % 3] - b[j]));
  }
  return best;
}

namespace {

// Does the segment from p to q pass through the triangle, even if all points are wrong by up to `off`?
bool passes(const Vec3& p, const Vec3& q, std::span<const Vec3> face, double off) {
  const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
  const double length = normal.norm();
  const double above = normal.dot(p - face[0]);
  const double below = normal.dot(q - face[0]);
  if (!(std::min(std::abs(above), std::abs(below)) > off * length) || (above > 0.0) == (below > 0.0))
    return false;
  const Vec3 x = p + (above / (above - below)) * (q - p);
  const double steep = std::abs(above - below) / (length * (q - p).norm());  // sine of the angle
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = face[(k + 1) % 3] - face[k];
    if (!(normal.dot(side.cross(x - face[k])) * steep > off * length * side.norm())) return false;
  }
  return true;
}

}  // namespace

bool certainly_cross(std::span<const Vec3> a, std::span<const Vec3> b, double off) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (passes(a[k], a[(k + 1) % 3], b, 4.0 * off) || passes(b[k], b[(k + 1) % 3], a, 4.0 * off)) return true;
  }
  return false;
}

}  // namespace impinge
