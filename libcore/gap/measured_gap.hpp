// SPDX-License-Identifier: GPL-3.0-or-later
// The gap of a vertex measured on the faces themselves, with a bound on its rounding: what a table cannot
// prove, beside a rim or where a surface is seen nearly edge-on, a few faces can. Theorem 5 (gap).
//
// The bound. TriangleCone::radius() errs by at most 60 u r / cos psi, u = 2^-53 and psi the angle between the
// ray and the normal of the face (stress/measure.hpp derives it); 1 / cos psi = |n| r / (n . v0). kSteps
// takes 64 for what is of second order. Of a face that is seen so nearly edge-on that a 16th is uncertain the
// radius is anything up to that of its farthest corner. Whether the ray of the vertex meets a face is decided
// exactly, for the vertex as to_socket() or to_ball() rounds it. Its length and the difference add 8 u of it.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "gap/certified_gap.hpp"
#include "gap/surface.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// Gap of a vertex of surface `of` at x (mm, frame of the other one) to `faces`, those of the other surface,
/// whose facing layer counts. Without a surface and clear for x = 0.
CertifiedGap measured_gap(Surface of, const NearFaces& faces, const Vec3& x);

/// Gaps of one scan by a table and what is proven about them, by vertex, mm.
struct BoundedScan {
  Surface scanned = Surface::ball;  // whose vertices
  const NearFaces& asked;           // the other surface
  std::span<const Vec3> places;     // of the vertices, in the frame of the other surface
  std::span<const double> gap;      // NaN where there is none
  std::span<const double> bound;    // infinite where nothing is proven
};

/// Where the smallest gap of all vertices that have one is proven to be.
struct SmallestBetween {
  double low = std::numeric_limits<double>::infinity();   // mm
  double high = std::numeric_limits<double>::infinity();  // mm; infinite if no vertex has a gap
  std::size_t measured = 0;  // vertices whose bound left it open, so that they were measured on the faces
};

/// Over both scans. The bounds are relied on, not checked.
SmallestBetween smallest_between(const BoundedScan& ball, const BoundedScan& socket);

}  // namespace impinge
