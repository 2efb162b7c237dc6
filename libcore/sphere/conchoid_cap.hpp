// SPDX-License-Identifier: GPL-3.0-or-later
// The area and the meridian of a cap round a pole of the rotational conchoid r = 1 + b cos(phi), in forms
// that lose no digits near the pole. Lengths are in units of its a, and 0 <= b < 1.
//
// Let chi be the polar angle from that pole, y = sin^2(chi / 2), r0 = 1 + b and q = -4 b at the north pole,
// r0 = 1 - b and q = 4 b at the south pole:
//   r = r0 + q y / 2,    v = ds / dchi = sqrt(r^2 + r'^2) = sqrt(r0^2 + q y).
// dA = 2 pi r sin(chi) ds = 4 pi r v dy. As r = (v^2 + 1 - b^2) / 2 and 2 v dv = q dy, the area is
//   A = (4 pi / q) [v^5 / 5 + (1 - b^2) v^3 / 3] from r0 to v,
// and v - r0 = q y / (v + r0) takes q, which is 0 on a sphere, out of the denominator:
//   A = 4 pi y / (v + r0) [(v^4 + v^3 r0 + v^2 r0^2 + v r0^3 + r0^4) / 5
//                          + (1 - b^2) (v^2 + v r0 + r0^2) / 3].
// All terms are positive. The meridian's length is s = 2 r0 E(chi / 2 | m), 1 - m = ((2 - r0) / r0)^2, which
// from the north pole is the thesis' 2 (a + b) E(phi / 2 | 4 a b / (a + b)^2).
#pragma once

#include <memory>

#include "sphere/elliptic_arc.hpp"
#include "sphere/smooth_table.hpp"

namespace impinge {

/// Where a cap is: about phi = 0, where the conchoid is farthest from its origin, or about phi = pi.
enum class Pole { north, south };

class ConchoidCap {
 public:
  ConchoidCap(Pole pole, double b);  // the cap round a pole; 0 <= b < 1, in units of a

  /// Area of the whole cap, chi <= pi / 2.
  double whole_area() const { return area(0.5); }
  /// Length of the meridian from the pole to chi = pi / 2.
  double whole_length() const { return 2.0 * pole_radius_ * arc_.length(); }

  /// Area of the cap up to y.
  double area(double y) const;
  /// Inverse of area(), up to whole_area(), from a table.
  double y_at_area(double area) const { return area * (*mean_thinness_)(area); }

  /// Length of the meridian from the pole to chi <= pi / 2.
  double length(double chi) const { return 2.0 * pole_radius_ * arc_.length(0.5 * chi); }
  /// Inverse of length().
  double angle(double length) const { return 2.0 * arc_.angle(0.5 * length / pole_radius_); }

 private:
  double find_y(double area) const;

  double pole_radius_;  // r0
  double bend_;         // q
  double product_;      // 1 - b^2
  EllipticArc arc_;
  std::shared_ptr<const SmoothTable> mean_thinness_;  // y over area
};

}  // namespace impinge
