// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the gap of a vertex on the faces themselves, with a bound on its rounding, where a table proves
// nothing: beside a rim, or where a surface is seen nearly edge-on. Theorem 5 (gap).
//
// The radius errs by at most 64 u r / cos psi, u = 2^-53, psi the angle between the ray and the normal of the
// face; 1 / cos psi = |n| r / (n . v0). On a face that is seen so nearly edge-on that a 16th is uncertain, it
// may be anything up to the farthest corner. Length and difference add 8 u of the length. Whether the ray
// meets a face is decided exactly, for the vertex as to_socket() or to_ball() rounds it.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "gap/certified_gap.hpp"
#include "gap/surface.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// Gap of a vertex of surface `of` at x (mm, frame of the other surface) to `faces`, the faces of the other
/// surface, whose facing layer counts. For x = 0 the answer is clear, without a surface.
CertifiedGap measured_gap(Surface of, const NearFaces& faces, const Vec3& x);

/// The gaps of one scan by a table, with bounds on their errors, by vertex, mm.
struct BoundedScan {
  Surface scanned = Surface::ball;  // whose vertices are scanned
  const NearFaces& asked;           // faces of the other surface
  std::span<const Vec3> places;     // of the vertices, in the frame of the other surface
  std::span<const double> gap;      // NaN where there is none
  std::span<const double> bound;    // on the error of the gap; infinite where nothing is proven
};

/// An interval that surely holds the smallest gap of all vertices that have one.
struct SmallestBetween {
  double low = std::numeric_limits<double>::infinity();   // mm
  double high = std::numeric_limits<double>::infinity();  // mm; infinite if no vertex has a gap
  std::size_t measured = 0;  // how many vertices were measured on the faces, as their bound left it open
};

/// The smallest gap over both scans. The bounds are taken as they are.
SmallestBetween smallest_between(const BoundedScan& ball, const BoundedScan& socket);

}  // namespace impinge
