// SPDX-License-Identifier: GPL-3.0-or-later
// Caps of directions and ranges of radii, and the cap and range of a face.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "sphere/direction.hpp"

namespace impinge {

/// All directions within `radius` radians of a unit axis.
struct DirectionCap {
  Vec3 axis;            // unit vector
  double radius = 0.0;  // radians
};

/// A range of radii, mm; low > high if it is empty.
struct RadiusRange {
  double low = std::numeric_limits<double>::infinity();    // the least radius
  double high = -std::numeric_limits<double>::infinity();  // the largest radius

  /// Widens the range to hold a radius, mm.
  void include(double radius) {
    low = std::min(low, radius);
    high = std::max(high, radius);
  }
  bool empty() const { return low > high; }  // nothing has been included
};

/// How much of a set of directions the surface covers.
enum class Cover { none, part, whole };

/// Allowance for the rounding of unit vectors, their products and the angles between them (angle_between()),
/// which is below 16 2^-53 = 1.8e-15.
inline constexpr double kDirectionSlack = 1e-12;

/// Ranges are made wider by kRangeSlack of the radius, and caps by kCapSlack radians. A radius has a rounding
/// error of 84 2^-53 (1 + tan psi) of itself (error_bound.hpp), 1e-10 up to tan psi = kSteepSlope. The range
/// of a steeper face holds all radii up to its farthest corner.
inline constexpr double kRangeSlack = 1e-9;
inline constexpr double kCapSlack = 1e-10;
inline constexpr double kSteepSlope = 1e4;

/// A face as seen from the centre.
struct FaceCap {
  DirectionCap cap;   // holds its directions if less than a quarter turn wide
  RadiusRange range;  // holds its radii, mm
  int side = 0;       // orientation of its corners, +1 or -1; 0 for a face that covers no direction

  bool small() const { return cap.radius < 0.5 * kPi; }  // does the cap hold the directions?
};

/// Cap and range of the face with these corners (mm, centre frame), rounded outwards. If a corner is at the
/// centre the cap holds all directions.
FaceCap face_cap(const std::array<Vec3, 3>& corners);

}  // namespace impinge
