// SPDX-License-Identifier: GPL-3.0-or-later
// A face on the flat (theta, phi) chart of the thesis (Figures 30-34), with its three pole cases.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge::lab {

// Angles in radians; theta may be outside [0, 2 pi), so that a drawn triangle is in one piece. radius in mm.
struct ChartPoint {
  double theta = 0.0;   // azimuth
  double phi = 0.0;     // polar angle
  double radius = 0.0;  // of the face at these angles
};

using ChartTriangle = std::array<ChartPoint, 3>;  // its corners

// The flat triangles that represent a face: one if the face is clear of the poles. Otherwise it is cut into
// triangles with a corner at the pole: one if the pole is a corner (case 1), two if it is on an edge (case
// 2), three if it is inside (case 3, Figure 34). Each of these becomes the quadrilateral between its two
// other corners and their projections onto the line phi = 0 (or pi), which is drawn as two triangles.
std::vector<ChartTriangle> chart_triangles(const TriangleCone& cone);

// Which entries of an RSID table a few faces fill: exactly, drawn as in the thesis, and drawn without its
// treatment of the poles (thesis, Section 3.2, Figures 32 to 34).

// An entry that at least one of the three ways fills. Radii in mm, NaN where a way does not fill it.
struct EntryCoverage {
  std::size_t entry = 0;      // index of the entry
  bool met = false;           // does the ray along the entry meet a face, with its boundary? exact
  bool drawn = false;         // does fill_thesis() fill it (methods/thesis_raster.hpp)?
  bool direct = false;        // in the flat triangle between the corners' own angles: wrong at pole and seam
  double met_radius = 0.0;    // on the face that is met
  double drawn_radius = 0.0;  // from fill_thesis()
};

// The coverage, in the order of entries. `mesh` is in the centre frame and has a few faces that do not
// overlap as seen from the centre; each entry is tested against each face.
std::vector<EntryCoverage> chart_coverage(const TriangleMesh& mesh, const Rsid& scheme);

// The faces that meet the ray along a unit vector, boundary included, with all vertices of the mesh.
TriangleMesh faces_along(const TriangleMesh& mesh, const Vec3& direction);

}  // namespace impinge::lab
