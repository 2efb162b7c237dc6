// SPDX-License-Identifier: GPL-3.0-or-later
// What a turn does to a scalar product, and when that is near zero: the closed form behind every contact.
//
// A vector a that has turned by an angle t about +z has a(t) . b = c cos t + s sin t + k for any fixed b.
// Every condition of contact between a turning surface and one at rest is such a function:
//   a corner p on the plane n.x = d of a face                  p . n - d
//   two edges a + l.. and c + m.. in one plane (Pluecker)      l . (c x m) + (a x l) . m
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "sphere/direction.hpp"

namespace impinge {

/// f(t) = cosine cos t + sine sin t + constant, t in radians. Theorem 12 (turn).
struct Sinusoid {
  double cosine = 0.0;    // c
  double sine = 0.0;      // s
  double constant = 0.0;  // k
};

/// a(t) . b, a turning about +z.
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

/// The parts of a turn in which |f| <= bound, bound > 0; they may overlap. Rounding is the caller's: bound
/// must exceed that of the coefficients by a factor of ten.
AngleSpans near_zero(const Sinusoid& f, double bound);

}  // namespace impinge
