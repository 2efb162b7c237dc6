// SPDX-License-Identifier: GPL-3.0-or-later
// Which entries of an RSID table a few faces fill: exactly, drawn with the thesis' treatment of the poles,
// and drawn without it (thesis, Section 3.2, Figures 32 to 34).
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {

// An entry that at least one of the three ways fills. Radii in mm, NaN where that way does not fill it.
struct EntryCoverage {
  std::size_t entry = 0;  // number of the entry
  bool met = false;       // the ray along the entry meets a face, boundary included: exact
  bool drawn = false;     // by fill_thesis() (methods/thesis_raster.hpp)
  bool direct = false;  // in the flat triangle between the corners' own angles: wrong at a pole and the seam
  double met_radius = 0.0;    // of the face that is met
  double drawn_radius = 0.0;  // that fill_thesis() gives
};

// Coverage in the order of entries. mesh in the centre frame, a few faces (each entry is tested against each
// face) that do not overlap as seen from the centre.
std::vector<EntryCoverage> chart_coverage(const TriangleMesh& mesh, const Rsid& scheme);

// The faces that meet the ray along a unit vector, boundary included, with all vertices of the mesh.
TriangleMesh faces_along(const TriangleMesh& mesh, const Vec3& direction);

}  // namespace impinge::lab
