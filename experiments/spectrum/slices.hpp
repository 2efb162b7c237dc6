// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere in parallel slices, as CT gives it (thesis, Section 3.5.2, Figure 45).
#pragma once

#include <cstddef>
#include <vector>

namespace impinge {

/// Slice i lies i thicknesses above the middle plane, which holds the centre.
struct Slice {
  std::size_t index = 0;  // i, from the middle slice
  double height = 0.0;    // mm
  double phi = 0.0;  // angle from the axis at which the slice cuts the sphere, arccos(height / r), radians
  double gap = 0.0;  // difference of phi to the slice below, radians; 0 for slice 0
};

/// Slices of the upper half, the middle one first: all with height <= radius (mm). A sphere is cut by twice
/// as many less one. std::invalid_argument unless 0 < thickness <= radius.
std::vector<Slice> slices_of_sphere(double radius, double thickness);

}  // namespace impinge
