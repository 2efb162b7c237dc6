// SPDX-License-Identifier: GPL-3.0-or-later
// A scalar product with a vector that turns about +z, as a function of the angle, and where it is near zero.
// Every condition of contact between a turning surface and one at rest is such a function. Theorem 12 (turn).
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "sphere/direction.hpp"

namespace impinge {

/// f(t) = cosine cos t + sine sin t + constant, t in radians.
struct Sinusoid {
  double cosine = 0.0;
  double sine = 0.0;
  double constant = 0.0;
};

/// a(t) . b, where a(t) is a turned by t about +z.
inline Sinusoid turned_dot(const Vec3& a, const Vec3& b) {
  return {a.x() * b.x() + a.y() * b.y(), a.x() * b.y() - a.y() * b.x(), a.z() * b.z()};
}

/// The sum of two functions of the same angle.
inline Sinusoid operator+(const Sinusoid& f, const Sinusoid& g) {
  return {f.cosine + g.cosine, f.sine + g.sine, f.constant + g.constant};
}

/// The vector turned by that angle about +z.
Vec3 turned(const Vec3& x, double angle);

/// A rotation that takes a unit axis to +z.
Eigen::Matrix3d rotation_to_z(const Vec3& axis);

/// Angles from `from` to `to`, radians in [0, 2 pi].
struct AngleSpan {
  double from = 0.0;  // where the span begins
  double to = 0.0;    // where it ends; no less
};

/// Up to four spans, which a loop goes through.
struct AngleSpans {
  std::array<AngleSpan, 4> span;                                // the first `count` of them
  std::size_t count = 0;                                        // of spans
  const AngleSpan* begin() const { return span.data(); }        // the first span
  const AngleSpan* end() const { return span.data() + count; }  // behind the last span
};

/// Spans of [0, 2 pi] that hold all angles with |f| <= bound, bound > 0; they may overlap. The caller chooses
/// a bound at least ten times as large as the rounding of the coefficients.
AngleSpans near_zero(const Sinusoid& f, double bound);

}  // namespace impinge
