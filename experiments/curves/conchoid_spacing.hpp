// SPDX-License-Identifier: GPL-3.0-or-later
// Rays at equal angles from a point of the axis against the arc of a conchoid from phi = 0 (apex) to 90
// degrees (rim): how long are the segments they cut? (thesis, Figure 53)
//
// Heights are those on the axis in the conchoid frame, mm; angles in radians. An origin is inside of the
// arc, 0 <= height < a + b, else std::invalid_argument: from there every ray meets the arc once, for the
// arc is convex and so is what it closes with the disc of its rim.
#pragma once

#include <cstddef>
#include <vector>

#include "curves/conchoid.hpp"

namespace impinge {

/// Angle at the origin between the axis and the point of the arc at phi.
double ray_angle(const ConchoidShape& shape, double height, double phi);

/// Length of arc per angle at the origin, ds / dalpha, mm per radian: the limit of the segments of many rays.
double spacing_rate(const ConchoidShape& shape, double height, double phi);

/// phi at which rays at equal angles, the first on the axis and the last through the rim, meet the arc.
/// Two rays or more.
std::vector<double> ray_cuts(const ConchoidShape& shape, double height, std::size_t rays);

/// Lengths of the rays - 1 segments, from the apex on, mm.
std::vector<double> segment_lengths(const ConchoidShape& shape, double height, std::size_t rays);

}  // namespace impinge
