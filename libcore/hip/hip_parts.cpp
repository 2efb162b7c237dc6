// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/hip_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mesh/icosphere.hpp"

namespace impinge {
namespace {

// Shares of the width of the greater trochanter: half its height and depth, our choice.
constexpr double kHalfHeight = 0.65;
constexpr double kHalfDepth = 0.35;
constexpr double kTipToTip = 67.5;          // mm, of the trochanters (doi:10.18203/2320-6012.ijrms20190023)
constexpr double kLesserLength = 1.5;       // half of it, along the shaft, to its height
constexpr double kSpineHalfLength = 11.0;   // mm, half of 22 (Hapa 2013)
constexpr double kSpineHalfWidth = 8.0;     // mm, half of 16
constexpr double kEdgeOfIcosahedron = 1.1;  // to its radius, about
constexpr double kMostHalvings = 4.0;

// The plane of neck and shaft from above: `out` points to the shaft, `back` is perpendicular to it.
struct ShaftFrame {
  Vec3 out;
  Vec3 back;
};

ShaftFrame shaft_frame(const HipSurface& hip) {
  const Vec3 out = Vec3(hip.neck.x(), hip.neck.y(), 0.0).normalized();
  return {out, out.cross(Vec3::UnitZ())};
}

Eigen::Matrix3d columns(const Vec3& a, const Vec3& b, const Vec3& c) {
  Eigen::Matrix3d axes;
  axes << a, b, c;
  return axes;
}

Vec3 greater_tip(const HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  const ShaftFrame at = shaft_frame(hip);
  return p.greater_trochanter_offset * at.out + p.greater_trochanter_behind * at.back +
         p.greater_trochanter_tip * Vec3::UnitZ();
}

BonePart greater_trochanter(const HipSurface& hip) {
  const double width = hip.parameters.greater_trochanter_width;
  const ShaftFrame at = shaft_frame(hip);
  return {"greater trochanter", greater_tip(hip) - kHalfHeight * width * Vec3::UnitZ(),
          columns(kHalfDepth * width * at.out, 0.5 * width * -at.back, kHalfHeight * width * Vec3::UnitZ())};
}

// Its middle lies on the surface of the shaft, as far below the greater tip as the tips are apart.
BonePart lesser_trochanter(const HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  const double height = p.lesser_trochanter_height;
  const double turn = p.lesser_trochanter_angle * kDegree;
  const Vec3 from = -std::cos(turn) * Vec3::UnitX() - std::sin(turn) * Vec3::UnitY();  // off the shaft
  Vec3 on_shaft = p.neck_length * hip.neck;
  on_shaft.z() = 0.0;
  const Vec3 flat = on_shaft + p.shaft_radius * from;
  const Vec3 tip = greater_tip(hip);
  const double apart = (flat + height * from - Vec3(tip.x(), tip.y(), 0.0)).norm();
  const double below = std::sqrt(std::max(0.0, kTipToTip * kTipToTip - apart * apart));
  return {"lesser trochanter", flat + (tip.z() - below) * Vec3::UnitZ(),
          columns(height * from, height * Vec3::UnitZ().cross(from), kLesserLength * height * Vec3::UnitZ())};
}

// Its middle lies in the plane of the rim, without pincer or other additions.
BonePart spine(const HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  const double half = p.half_opening * kDegree;
  const Vec3 outwards = clock_direction(-hip.opening, hip.rim_clock, 0.5 * kPi, p.aiis_clock);
  const double from_axis = hip.socket_radius * std::sin(half) + p.aiis_distance;
  const Vec3 middle =
      hip.socket_centre - hip.socket_radius * std::cos(half) * hip.opening + from_axis * outwards;
  return {"AIIS", middle,
          columns(kSpineHalfLength * outwards, kSpineHalfWidth * hip.opening.cross(outwards),
                  p.aiis_height * hip.opening)};
}

// The crossing t of the ray t u with the ellipsoid, |axes^-1 (t u - middle)| = 1; `sign` picks one of two.
double crossing(const BonePart& part, const Vec3& direction, double sign) {
  const Eigen::Matrix3d inverse = part.axes.inverse();
  const Vec3 along = inverse * direction;
  const Vec3 middle = inverse * part.middle;
  const double a = along.squaredNorm();
  const double b = along.dot(middle);
  const double root = std::sqrt(b * b - a * (middle.squaredNorm() - 1.0));  // NaN where there is none
  return b > 0.0 ? (b + sign * root) / a : std::nan("");
}

}  // namespace

double BonePart::nearest(const Vec3& direction) const { return crossing(*this, direction, -1.0); }

double BonePart::farthest(const Vec3& direction) const { return crossing(*this, direction, 1.0); }

std::vector<BonePart> femur_parts(const HipSurface& hip) {
  const HipParameters& p = hip.parameters;
  std::vector<BonePart> parts;
  if (p.shaft_length == 0.0) return parts;
  if (p.greater_trochanter_width > 0.0) parts.push_back(greater_trochanter(hip));
  if (p.lesser_trochanter_height > 0.0) parts.push_back(lesser_trochanter(hip));
  return parts;
}

std::vector<BonePart> acetabulum_parts(const HipSurface& hip) {
  if (hip.parameters.aiis_height == 0.0) return {};
  return {spine(hip)};
}

TriangleMesh mesh_of(const BonePart& part, double spacing) {
  const double size = part.axes.colwise().norm().maxCoeff();
  const double halvings = std::log2(kEdgeOfIcosahedron * size / spacing);
  TriangleMesh mesh =
      icosphere(1.0, static_cast<std::size_t>(std::clamp(std::round(halvings), 1.0, kMostHalvings)));
  mesh.vertices = mapped(part.axes, mesh.vertices);
  return relative_to(std::move(mesh), -part.middle);
}

}  // namespace impinge
