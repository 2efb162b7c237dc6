// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/direction.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace impinge {

Angles to_angles(const Vec3& x) {
  const double rho = std::hypot(x.x(), x.y());
  if (rho == 0.0) return {x.z() < 0.0 ? kPi : 0.0, 0.0};
  double theta = std::atan2(x.y(), x.x());
  if (theta < 0.0) theta += 2.0 * kPi;
  // A tiny negative angle rounds up to a whole turn, which is the seam itself.
  if (theta >= 2.0 * kPi || theta == 0.0) theta = 0.0;
  return {std::atan2(rho, x.z()), theta};
}

Vec3 to_direction(Angles angles) {
  const double s = std::sin(angles.phi);
  return {s * std::cos(angles.theta), s * std::sin(angles.theta), std::cos(angles.phi)};
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

CosSin half_turn_fraction(long k, long n) {
  k %= 2 * n;
  if (k < 0) k += 2 * n;
  if (k > n) {  // lower half circle: mirror in the x axis
    const CosSin c = half_turn_fraction(2 * n - k, n);
    return {c.cos, -c.sin};
  }
  if (2 * k > n) {  // second quadrant: mirror in the y axis
    const CosSin c = half_turn_fraction(n - k, n);
    return {-c.cos, c.sin};
  }
  if (4 * k > n) {  // second octant: mirror in the diagonal, cos(pi k / n) = sin(pi (n - 2 k) / (2 n))
    const double rest = kPi * static_cast<double>(n - 2 * k) / static_cast<double>(2 * n);
    return {std::sin(rest), std::cos(rest)};
  }
  const double angle = kPi * static_cast<double>(k) / static_cast<double>(n);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace impinge
