// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling rays from the conchoid's origin over its arc from phi = 0 to 90 degrees, both ends included
// (thesis, Section 5.1.2): at equal angles, adjusted by the thesis' closed form (Eq. 16), and cutting the arc
// into exactly equal lengths.
//
// All angles in radians; all functions return one angle a ray, ascending. Fewer than two rays are
// std::invalid_argument: one ray cuts nothing.
#pragma once

#include <cstddef>
#include <vector>

#include "curves/conchoid.hpp"

namespace impinge {

/// The thesis puts 2 a b in place of a^2 + b^2 under the root, so that Eq. 12 becomes
///   p(phi) = 4 sqrt(a b) sin(phi / 2) = factor * b * sin(phi / 2),
/// with p = quarter * b at 90 degrees.
struct ConchoidClosedForm {
  double factor = 4.29;   // 4 sqrt(a b) / b
  double quarter = 3.03;  // p at 90 degrees, over b
};

/// As the thesis rounds them for a = 1.15 b: the defaults.
ConchoidClosedForm thesis_closed_form();

/// Unrounded, of a shape with b > 0 (for a circle the form is 0 / 0: std::invalid_argument).
ConchoidClosedForm closed_form(const ConchoidShape& shape);

/// p(phi), mm.
double closed_form_length(const ConchoidShape& shape, double phi);

/// 0, 90 / (rays - 1), ... 90 degrees.
std::vector<double> original_angles(std::size_t rays);

/// Eq. 16: phi_i = 2 asin(quarter * i / ((rays - 1) * factor)). An argument past 1 by rounding is 1; a form
/// whose arguments pass 1 by more (quarter > factor) or that is not positive is std::invalid_argument.
std::vector<double> adjusted_angles(const ConchoidClosedForm& form, std::size_t rays);

/// The angles at which the exact length of the meridian is i / (rays - 1) of that at 90 degrees.
std::vector<double> equal_arc_angles(const ConchoidShape& shape, std::size_t rays);

}  // namespace impinge
