// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest and the largest radius of a face within a cap of directions.
//
// Along directions u a face has the radius r = p / (n.u), n its unit normal and p the distance of its plane.
// {r <= c} is a cap about n, so that over a convex set of directions r is largest at an extreme point of the
// set, and smallest at n if the set holds it, otherwise on its boundary. The part of a face within a cap is
// bounded by pieces of its edges, on which r is the distance of a straight line from the centre, and by arcs
// of the circle of the cap, on which n.u is a sinusoid. Hence its extremes are among
//   the ends of each piece of an edge and the point of it that is nearest to the centre,
//   the points of the circle towards n and away from it, where the face covers them,
//   n, where cap and face hold it.
// All are computed in the gnomonic plane of the cap, x -> x / (x.axis) - axis, in which edges are straight
// and the cap is a disc.
#pragma once

#include <array>
#include <optional>

#include "sphere/triangle_cone.hpp"
#include "table/face_cap.hpp"

namespace impinge::lab {

/// What of a face lies in a cap.
struct FaceInCap {
  RadiusRange range;                // holds every radius of that part
  std::array<bool, 3> side_inside;  // may the side from corner k to k + 1 pass through the cap?
};

/// Ranges are wider than the truth by kRangeSlack of the radius, and caps by this share of their own radius
/// and kCapSlack radians more. Rounding stays below both, u = 2^-53:
///   a radius p / (n . x)  21 u k by kPlaneRoundings (surface_plane.hpp); a face with a condition k above
///                         1e-10 / kPlaneTestError = 4.5e4 is taken whole: 1.1e-10; tables in double have
///                         as much
///   a point of the disc   coordinates up to 1 / kLeastDepth = 20 with 10 roundings: 2e-14 of kCapSlack
///   the cap of a face     |axis - axis'| with 4 roundings: 1e-15 of kCapSlack
/// and the lengths that are compared with a range have 4 roundings.
inline constexpr double kCapShare = 1e-7;  // of the radius of a cap

/// A face that is asked about many caps.
class FaceRange {
 public:
  /// The cone must not be edge-on.
  explicit FaceRange(const TriangleCone& cone);

  /// None if the face is certainly outside of the cap. The whole range of the face where the formulas would
  /// be ill-conditioned: a cap of more than kWidestCap, a corner almost a quarter turn away from the axis, a
  /// face that is almost edge-on.
  std::optional<FaceInCap> in_cap(const DirectionCap& cap) const;

  static constexpr double kWidestCap = 1.2;  // radians

 private:
  void include_edges(const DirectionCap& cap, double tangent, FaceInCap& part) const;
  void include_inside(const DirectionCap& cap, double tangent, FaceInCap& part) const;

  TriangleCone cone_;
  Vec3 normal_;       // unit, away from the centre
  DirectionCap own_;  // holds the face
  bool steep_;        // taken whole
  RadiusRange whole_;
};

}  // namespace impinge::lab
