// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a turn of a spiral may lie in a triangle cone or near it, for walkers.
//
// A turn crosses the azimuths of the triangle's angular box in a few pieces between borders of fixed azimuth.
// It is taken for the parallel of its middle, phi: nowhere more than half of its rise in phi away. Let n . u
// be the signed distance of a direction u from an edge plane. Along a piece that is w wide a parallel leaves
// its chord by at most sin(phi) w^2 / 8, so that n . u leaves the straight line between its values at both
// borders by at most
//   |n| (sin(phi) w^2 / 8 + rise / 2).
// A direction within `margin` of the triangle has n . u >= -|n| sin(margin). Where line and both allowances
// together are negative there is nothing to be found.
#pragma once

#include <array>
#include <cstddef>

#include "sphere/angular_box.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {

class TurnClip {
 public:
  /// Shares of a piece, 0 at its first border and 1 at its second; nothing where from > to.
  struct Part {
    double from;  // share of the piece at which the part begins
    double to;    // and at which it ends
  };

  /// A turn between the outermost borders. Radians.
  struct Turn {
    CosSin polar;  // of its middle
    double rise;   // of its polar angle, at least
  };

  /// `spacing` is that of the turns, on which the number of pieces depends; `doubt` bounds the error of an
  /// entry's direction. Radians.
  struct Accuracy {
    double margin;   // how near to the triangle entries count
    double spacing;  // of turns
    double doubt;    // of directions
  };

  /// Of the triangle `cone`, whose angular box (with the margin) is `box`.
  TurnClip(const TriangleCone& cone, const AngularBox& box, const Accuracy& accuracy);

  std::size_t pieces() const { return pieces_; }  // into which the azimuths of the box are divided
  /// Azimuth of border k = 0 ... pieces(), in turns.
  double azimuth(std::size_t k) const { return azimuth_ + static_cast<double>(k) * width_; }

  /// Of the piece between borders k and k + 1.
  Part part(std::size_t k, const Turn& turn) const {
    const double bend = turn.polar.sin * bend_ + 0.5 * turn.rise;
    Part part{0.0, 1.0};
    for (std::size_t e = 0; e < 3; ++e) {
      const double here = turn.polar.cos * upright_[e] + bend * length_[e] + leeway_[e];
      const double a = turn.polar.sin * level_[k][e] + here;
      const double b = turn.polar.sin * level_[k + 1][e] + here;
      if (a < 0.0 && b < 0.0) return {1.0, 0.0};
      if (a < 0.0 && part.from < a / (a - b)) part.from = a / (a - b);
      if (b < 0.0 && part.to > a / (a - b)) part.to = a / (a - b);
    }
    return part;
  }

 private:
  static constexpr std::size_t kMostPieces = 64;

  std::size_t pieces_;
  double azimuth_;                                            // of the first border, turns
  double width_;                                              // of a piece, turns
  double bend_;                                               // w^2 / 8
  std::array<double, 3> length_;                              // of n
  std::array<double, 3> leeway_;                              // margin and rounding
  std::array<double, 3> upright_;                             // z of n
  std::array<std::array<double, 3>, kMostPieces + 1> level_;  // n . (cos theta, sin theta, 0) at the borders
};

}  // namespace impinge
