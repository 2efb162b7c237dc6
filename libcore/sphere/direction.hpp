// SPDX-License-Identifier: GPL-3.0-or-later
// A direction is a unit vector from the centre of rotation; its spherical angles are as in the thesis.
#pragma once

#include <numbers>

#include <Eigen/Core>

namespace impinge {

/// A point or vector in millimetres, or a unit vector where the name says direction.
using Vec3 = Eigen::Vector3d;

inline constexpr double kPi = std::numbers::pi;  // half a turn, radians
inline constexpr double kDegree = kPi / 180.0;   // radians in one degree

/// Spherical angles in radians (thesis, Eq. 5-6).
struct Angles {
  double phi = 0.0;    // polar angle from +z, in [0, pi]
  double theta = 0.0;  // azimuth from +x towards +y, in [0, 2 pi)
};

/// Angles of a nonzero vector of any length. phi comes from atan2(hypot(x, y), z): the arccosine of Eq. 6
/// loses half of the digits near the poles. theta at a pole is 0.
Angles to_angles(const Vec3& x);

/// Unit vector of the given angles (Eq. 5 with d = 1).
Vec3 to_direction(Angles angles);

/// Angle between two nonzero vectors, in [0, pi], accurate for nearly parallel ones too.
double angle_between(const Vec3& a, const Vec3& b);

/// Cosine and sine of pi * k / n for integers n > 0 and any k. Multiples of a quarter turn are exact, and the
/// symmetries of the circle hold bit for bit, so that grid points on the axes lie on the axes.
struct CosSin {
  double cos = 1.0;  // of pi k / n
  double sin = 0.0;  // of pi k / n
};
CosSin half_turn_fraction(long k, long n);  // cosine and sine of pi k / n, see above

}  // namespace impinge
