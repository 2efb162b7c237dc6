// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling rays from the conchoid's origin over its arc from phi = 0 to 90 degrees, both ends included
// (thesis, Section 5.1.2): at equal angles, adjusted by the thesis' closed form (Eq. 16), and so that they
// cut the arc into exactly equal lengths. All angles are in radians; all functions return one angle per ray,
// ascending. They throw std::invalid_argument for fewer than two rays, since one ray cuts nothing.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "curves/conchoid.hpp"

namespace impinge {

/// The thesis replaces a^2 + b^2 under the root by 2 a b, so that Eq. 12 becomes
///   p(phi) = 4 sqrt(a b) sin(phi / 2) = factor * b * sin(phi / 2),
/// with p = quarter * b at 90 degrees.
struct ConchoidClosedForm {
  double factor = 4.29;   // 4 sqrt(a b) / b
  double quarter = 3.03;  // p at 90 degrees, divided by b
};

/// The thesis' rounded numbers for a = 1.15 b; these are the defaults.
ConchoidClosedForm thesis_closed_form();

/// Unrounded numbers for a shape with b > 0. Throws std::invalid_argument for a circle, whose form is 0 / 0.
ConchoidClosedForm closed_form(const ConchoidShape& shape);

/// p(phi), mm.
double closed_form_length(const ConchoidShape& shape, double phi);

/// 0, 90 / (rays - 1), ... 90 degrees.
std::vector<double> original_angles(std::size_t rays);

/// Eq. 16: phi_i = 2 asin(quarter * i / ((rays - 1) * factor)). An argument that rounding has put past 1
/// counts as 1. Throws std::invalid_argument for a form whose arguments pass 1 by more (quarter > factor), or
/// that is not positive.
std::vector<double> adjusted_angles(const ConchoidClosedForm& form, std::size_t rays);

/// The angles at which the exact length of the meridian is i / (rays - 1) of its length at 90 degrees.
std::vector<double> equal_arc_angles(const ConchoidShape& shape, std::size_t rays);

// How long are the segments that rays at equal angles, from a point of the axis, cut from the arc of a
// conchoid from phi = 0 (apex) to 90 degrees (rim)? (thesis, Figure 53)
//
// Heights are those on the axis in the conchoid frame, mm; angles in radians. The origin must be inside the
// arc, 0 <= height < a + b, else std::invalid_argument. From there every ray meets the arc once, since the
// arc and the disc of its rim enclose a convex region.

/// Angle at the origin between the axis and the point of the arc at phi.
double ray_angle(const ConchoidShape& shape, double height, double phi);

/// Length of arc per angle at the origin, ds / dalpha, mm per radian: the limit of the segments of many rays.
double spacing_rate(const ConchoidShape& shape, double height, double phi);

/// phi at which two or more rays at equal angles meet the arc; the first is the axis, the last meets the rim.
std::vector<double> ray_cuts(const ConchoidShape& shape, double height, std::size_t rays);

/// Lengths of the rays - 1 segments, from the apex on, mm.
std::vector<double> segment_lengths(const ConchoidShape& shape, double height, std::size_t rays);

// Points of a conchoid's axis from which rays may sample its arc from phi = 0 (apex) to 90 degrees (rim).
// Heights are those on the axis in the conchoid frame, mm. Throws std::invalid_argument for an invalid shape.

/// A point of the axis, mm above the conchoid's origin.
struct SamplingOrigin {
  std::string_view name;  // in tables of results
  double height = 0.0;    // mm
};

/// The conchoid's origin, and possible meanings of "the center of the model", for the arc from apex to rim
/// ("cap") or for the whole curve: middle of the extent along the axis, centroid of the curve, centroid of
/// the surface, centre of the best sphere. Only those inside the arc are returned.
std::vector<SamplingOrigin> sampling_origins(const ConchoidShape& shape);

/// The sphere about a point of the axis that fits the cap's surface best, by least squares.
struct AxialSphere {
  double height = 0.0;           // mm
  double radius = 0.0;           // mm
  double lowest_residual = 0.0;  // mm, of distance from the centre minus radius, over the cap
  double highest_residual = 0.0;
};
AxialSphere fit_axial_sphere(const ConchoidShape& shape);  // the sphere for the cap

}  // namespace impinge
