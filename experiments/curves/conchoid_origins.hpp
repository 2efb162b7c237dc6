// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a conchoid's axis from which rays may sample its arc from phi = 0 (apex) to 90 degrees (rim).
// Heights are those on the axis in the conchoid frame, mm. A shape that is none is std::invalid_argument.
#pragma once

#include <string_view>
#include <vector>

#include "curves/conchoid.hpp"

namespace impinge {

/// A point of the axis, mm above the conchoid's origin.
struct SamplingOrigin {
  std::string_view name;  // in tables of results
  double height = 0.0;    // mm
};

/// The conchoid's origin, and what "the center of the model" may mean for the arc from apex to rim ("cap") or
/// for the whole curve: middle of the extent along the axis, centroid of the curve, centroid of the surface,
/// centre of the best sphere. Only those inside of the arc.
std::vector<SamplingOrigin> sampling_origins(const ConchoidShape& shape);

/// The sphere about a point of the axis that fits the cap's surface best in the sense of least squares.
struct AxialSphere {
  double height = 0.0;           // mm
  double radius = 0.0;           // mm
  double lowest_residual = 0.0;  // mm, of distance from the centre minus radius over the cap
  double highest_residual = 0.0;
};
AxialSphere fit_axial_sphere(const ConchoidShape& shape);  // that sphere of the cap

}  // namespace impinge
