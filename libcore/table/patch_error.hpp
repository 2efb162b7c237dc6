// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds how far an interpolated value Y can be from the surface over a rectangle of a patch, from the errors
// at its corners and the faces and edges that may meet it: Theorem 2 (table), whose y is r for the `smooth`
// interpolant and |x| / r for `mesh_exact`, x the point of the scheme's solid.
//
// The theorem needs a layer whose radius is continuous (no rim, rim.hpp) and that changes between faces at
// their edges alone. Where two faces that overlap in the view may both belong to it, the bound is one of
// first order: the layer stays within a range of radii, and Y between its corners.
//
// Roundings are added. With u = 2^-53 and k the largest condition of the faces (kPlaneRoundings in
// surface_plane.hpp), they are, as shares of the largest radius r of the layer:
//   21 u k   of an entry              21 u k   of the surface at a corner
//   17 u     of a look-up (kSumRounding in sphere/stored_table.hpp)
//   40 u k   of q in |y''| and in the jumps: the bound is a multiple of them, no larger than r or of no use
// Together they are at most 4 kPlaneRoundings k. The formulas add terms above zero with less than 500
// roundings: kOwnRounding. Directions are moved by `angle_doubt`. If a corner's error is sampled aside of it
// by a share of the way, that share of the change of Y and y along the way is added.
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

/// Value and truth at a corner, in units of y; NaN if there is none.
struct CornerSample {
  double value = 0.0;  // of the interpolant
  double truth = 0.0;  // of the surface
};

/// A rectangle of a patch, with corners in the order (from, from), (to, from), (from, to), (to, to).
struct PatchView {
  PatchMotion motion;                  // over the rectangle
  DirectionCap cap;                    // holds all of its directions
  std::array<Vec3, 4> point;           // x(s, t) at the corners; unit vectors unless flat
  std::array<CornerSample, 4> corner;  // interpolant and surface there
  double least_tap = 0.0;              // in units of y
  double largest_tap = 0.0;            // in units of y
  std::array<double, 2> inset{};       // how far aside corners are sampled, as a share of the rectangle
  bool flat = false;                   // mesh_exact
};

/// What is proven about a rectangle.
struct PatchBound {
  double bound = 0.0;     // mm, on the error over the rectangle
  std::size_t split = 0;  // the coordinate that adds most to it: 0 for s, 1 for t
  bool tight = false;     // a smaller rectangle would not help
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
