// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/angular_box.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "sphere/orientation.hpp"

namespace impinge {
namespace {

constexpr double kRounding = 1e-12;     // slack for the rounding of angles
constexpr double kNearHalfTurn = 1e-9;  // an edge that close to a half turn of azimuth may touch the pole

// Takes in the highest and lowest point of the great circle through a and b where they lie on the arc a -> b.
void include_bulge(const Vec3& a, const Vec3& b, AngularBox& box) {
  const Vec3 normal = a.cross(b);
  if (normal.squaredNorm() == 0.0) return;  // both ends in one direction
  const double rise_at_a = normal.cross(a).z();
  const double rise_at_b = normal.cross(b).z();
  const double top = std::atan2(std::abs(normal.z()), std::hypot(normal.x(), normal.y()));
  if (rise_at_a >= 0.0 && rise_at_b <= 0.0) box.phi_min = std::min(box.phi_min, top);
  if (rise_at_a <= 0.0 && rise_at_b >= 0.0) box.phi_max = std::max(box.phi_max, kPi - top);
}

// The range of azimuths along the edges; the whole circle if a pole is inside or on the boundary.
void set_azimuths(const std::array<Vec3, 3>& corners, const std::array<Angles, 3>& angles, AngularBox& box) {
  double at = angles[0].theta;
  double low = at;
  double high = at;
  for (std::size_t k = 0; k < 3; ++k) {
    if (corners[k].x() == 0.0 && corners[k].y() == 0.0) return;  // on the axis: any azimuth
    const double step = std::remainder(angles[(k + 1) % 3].theta - angles[k].theta, 2.0 * kPi);
    if (std::abs(step) > kPi - kNearHalfTurn) return;  // the edge passes the pole
    at += step;
    low = std::min(low, at);
    high = std::max(high, at);
  }
  if (std::abs(at - angles[0].theta) > kPi) return;  // once round: the pole is inside
  box.theta_min = low;
  box.theta_width = high - low;
}

void widen(AngularBox& box, double margin) {
  box.phi_min = std::max(0.0, box.phi_min - margin);
  box.phi_max = std::min(kPi, box.phi_max + margin);
  // A cap of radius margin around a point at polar angle phi spans asin(sin(margin) / sin(phi)) of azimuth
  // each way.
  const double narrowest = std::min(std::sin(box.phi_min), std::sin(box.phi_max));
  const double spread = std::sin(margin) < narrowest ? std::asin(std::sin(margin) / narrowest) : kPi;
  box.theta_min -= spread;
  box.theta_width = std::min(2.0 * kPi, box.theta_width + 2.0 * spread);
}

}  // namespace

AngularBox angular_box(const std::array<Vec3, 3>& corners, double margin) {
  const std::array<Angles, 3> angles{to_angles(corners[0]), to_angles(corners[1]), to_angles(corners[2])};
  AngularBox box;
  box.phi_min = std::min({angles[0].phi, angles[1].phi, angles[2].phi});
  box.phi_max = std::max({angles[0].phi, angles[1].phi, angles[2].phi});
  for (std::size_t k = 0; k < 3; ++k) include_bulge(corners[k], corners[(k + 1) % 3], box);
  set_azimuths(corners, angles, box);
  const int side = orientation(corners[0], corners[1], corners[2]);
  if (side != 0) {  // else an arc: its bulge and azimuths tell all
    if (place_in_cone(corners, side, Vec3::UnitZ()) >= 0) box.phi_min = 0.0;
    if (place_in_cone(corners, side, -Vec3::UnitZ()) >= 0) box.phi_max = kPi;
  }
  widen(box, margin + kRounding);
  return box;
}

}  // namespace impinge
