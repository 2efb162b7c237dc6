// SPDX-License-Identifier: GPL-3.0-or-later
// How far an interpolation can be from a surface between the corners of a rectangle of a patch.
//
// Let y be what is interpolated: y = r for the `smooth` interpolant, y = |x| / r for `mesh_exact`, x the
// point of the scheme's solid. On a rectangle of (s, t) the interpolated value Y is linear in s and in t, so
// that Y minus the bilinear interpolation of y from the corners is the bilinear interpolation of the errors
// there, at most the largest of them. The rest is how far y is from its own bilinear interpolation. Along a
// line of s of width h, y is piecewise smooth, and a linear interpolation of it errs by at most
//   h^2 / 8 max |y''| + h / 4 sum |jumps of y'|:
// on a line of length h a hinge of slope j at a is interpolated too high by j a (h - a) / h. Interpolating in
// s and then in t, with non-negative weights, adds both. So, with all faces and edges that may meet
// the rectangle,
//   |Y - y| <= max over corners |Y - y| + sum over s, t of (h^2 / 8 max |y''| + h / 4 sum |jumps|
//              + h^2 / 8 max |Y''|),
// the last term where weights are not linear (PatchMotion::bend):
//   |Y''| <= sum |w''| / 2 (largest - least tap).
//
// On a plane q . x = 1 and for u = u(s) on the sphere, r = 1 / (q . u):
//   r'' = 2 r^3 (q . u')^2 + r |u'|^2 - r^2 q . a
// with the acceleration a along the sphere and |q_tangent| r = tan psi,
//   jump of r' = r^2 |(q_1 - q_2) . u'| at an edge, where q_1 . u = q_2 . u; and r tan psi times that of u',
// and y = q . x for mesh_exact, of which only the jumps |(q_1 - q_2) . x'| remain. No q . u' is farther from
// that of a chord of the rectangle than |q| times (|u''| / 2 along the line, / 4 across). A line that bends
// may cross an edge more than once. Between two crossings that follow each other the slope across the edge
// changes its sign, so that the jumps at both are together at most its change between them, and all of them
// at most |q_1 - q_2| times that of u' along the line.
//
// This requires that a layer's radius is continuous on the cell (no rim, rim.hpp) and changes from face to
// face at their edges alone: not where two faces that overlap in the view are both within its range. The
// layer's radius is within r exp(+-T way) of that of a corner, T the largest tan psi of the faces in that
// range, so that a face out of range is none of the layer's. Theorem 2 (table).
//
// Roundings are added. With u = 2^-53 and k the largest condition of the faces (kPlaneRoundings in
// surface_plane.hpp), in shares of the largest radius r of the layer:
//   21 u k   of an entry              21 u k   of the surface at a corner
//   17 u     of a look-up (kSumRounding in sphere/stored_table.hpp)
//   40 u k   of q in |y''| and in the jumps: the bound is a multiple of them, no larger than r or of no use
// together at most 4 kPlaneRoundings k. The formulas themselves are sums of terms above zero, of less than
// 500 roundings: kOwnRounding. Directions are moved by `angle_doubt`; an error that is sampled a little aside
// of its corner, by a share of the way, changes by that share of what Y and y change along the way, at most.
//
// Where this fails the bound is one of first order: the layer is within that range, Y between its corners.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "table/patches/patch.hpp"
#include "table/surface_index.hpp"

namespace impinge {

/// Corners on the border of a patch are sampled this share of it inside, where its own cell answers.
inline constexpr double kCornerInset = 1e-9;

/// Value and truth in units of y; NaN where there is none.
struct CornerSample {
  double value = 0.0;  // of the interpolant
  double truth = 0.0;  // of the surface
};

/// A rectangle of a patch. Corners in the order (from, from), (to, from), (from, to), (to, to).
struct PatchView {
  PatchMotion motion;                  // over the rectangle
  DirectionCap cap;                    // holds all of its directions
  std::array<Vec3, 4> point;           // x(s, t) at the corners; unit vectors unless flat
  std::array<CornerSample, 4> corner;  // interpolant and surface there
  double least_tap = 0.0;              // y
  double largest_tap = 0.0;            // y
  std::array<double, 2> inset{};       // how far aside corners are sampled, as a share of the rectangle
  bool flat = false;                   // mesh_exact
};

/// What is proven about a rectangle.
struct PatchBound {
  double bound = 0.0;     // mm, on the error over the rectangle
  std::size_t split = 0;  // the coordinate that adds most to it: 0 for s, 1 for t
  bool tight = false;     // no smaller rectangle would do better
};

/// Bounds rectangles one after the other; keeps scratch memory.
class PatchError {
 public:
  /// angle_doubt: how far rounding may move a direction, radians.
  PatchError(const SurfaceIndex& surface, double angle_doubt) : surface_(surface), doubt_(angle_doubt) {}

  /// Bounds the error over the rectangle. At least one corner must have a value.
  PatchBound operator()(const PatchView& view);

 private:
  struct LayerRange {
    double low;
    double high;
    double slope;
    double doubt;
  };
  LayerRange find_layer(const PatchView& view, const std::array<double, 4>& radius);
  bool has_overlap() const;
  std::array<double, 2> remainders(const PatchView& view, const LayerRange& layer) const;
  double first_order(const PatchView& view, const LayerRange& layer) const;
  double rounding(const PatchView& view, const LayerRange& layer) const;

  const SurfaceIndex& surface_;
  double doubt_;
  std::vector<std::uint32_t> faces_;  // that may belong to the layer
  std::vector<PlaneRange> ranges_;    // of each
};

}  // namespace impinge
