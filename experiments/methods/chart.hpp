// SPDX-License-Identifier: GPL-3.0-or-later
// A face on the flat (theta, phi) chart of the thesis (Figures 30-34), with its three pole cases.
#pragma once

#include <array>
#include <vector>

#include "sphere/triangle_cone.hpp"

namespace impinge::lab {

// theta and phi in radians; theta may lie outside [0, 2 pi) so that a drawn triangle is in one piece. radius
// in mm.
struct ChartPoint {
  double theta = 0.0;   // azimuth
  double phi = 0.0;     // polar angle
  double radius = 0.0;  // of the face there
};

using ChartTriangle = std::array<ChartPoint, 3>;  // its corners

// The flat triangles that stand for a face: one if the face is clear of the poles. Otherwise it is cut into
// triangles with a corner at the pole: one if the pole is a corner (case 1), two if it is on an edge (case
// 2), three if it is inside (case 3, Figure 34). Each becomes the quadrilateral between its two other corners
// and their projections onto the line phi = 0 (or pi), which is drawn as two triangles.
std::vector<ChartTriangle> chart_triangles(const TriangleCone& cone);

}  // namespace impinge::lab
