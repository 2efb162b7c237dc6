// SPDX-License-Identifier: GPL-3.0-or-later
// From a hip to the slices of a CT scan, back to a surface and on to a table: what each stage adds to the
// error of a gap (thesis, Sections 3.4 and 3.5.2). Each stage includes those before it:
//   slices      isosurface of an image without noise: partial volume, pixels, slices, surface between voxels
//   noise       isosurface of an image with Gaussian noise
//   decimation  to as many triangles as the thesis' models have
//   centre      of the sphere fitted to the ball, in place of the true one
//   table       RSID tables of both surfaces, interpolated
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hip/hip.hpp"
#include "imaging/ct_scan.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// The scanner, and how its images are processed.
struct SlicesOptions {
  ScanGrid grid;               // of the voxels
  ScanLevels levels;           // of the image with noise
  std::size_t faces = 12000;   // of each surface after decimation
  double precision_deg = 1.0;  // of the tables
};

// Directions in which ball and socket face each other, away from the rim, with their exact gaps.
struct FacingGaps {
  std::vector<Vec3> directions;  // unit vectors
  std::vector<double> gap;       // mm
};

// Those of `count` even directions in which, and in eight directions 3 degrees away, the gap is below 8 mm.
FacingGaps facing_gaps(const Hip& hip, std::size_t count);

// The gaps after one stage, against the true ones.
struct StageError {
  std::string stage;             // its name
  std::size_t ball_faces = 0;    // after the stage
  std::size_t socket_faces = 0;  // after the stage
  double mean_mm = 0.0;          // of gap minus true gap
  double rms_mm = 0.0;           // root mean square of gap minus true gap
  double largest_mm = 0.0;       // largest absolute difference
  double added_rms_mm = 0.0;     // root mean square of gap minus the gap of the stage before
  std::size_t directions = 0;    // number that was asked
  std::size_t missed = 0;        // of them, without a gap
};

// The errors of all stages, and the final surfaces.
struct SlicesResult {
  std::vector<StageError> stages;  // in their order
  TriangleMesh ball;               // after decimation, in the frame of the hip
  TriangleMesh socket;
  Vec3 centre = Vec3::Zero();  // fitted
};

// The hip must have closed surfaces (a socket with a wall). The bones are scanned one by one, as if they were
// perfectly separated in one image.
SlicesResult slices_to_surface(const Hip& hip, const FacingGaps& truth, const SlicesOptions& options);

}  // namespace impinge::lab
