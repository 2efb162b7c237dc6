// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which part of a turn of a spiral may lie in or near a triangle cone, for walkers.
//
// Within the triangle's angular box a turn is divided into a few pieces by borders of fixed azimuth. The turn
// is replaced by the parallel of its middle, phi, from which it is at most half of its rise in phi away. Let
// n be normal to an edge plane. Along a piece of width w a parallel leaves its chord by at most sin(phi) w^2
// / 8, so that n . u leaves the straight line between its values at both borders by at most
//   |n| (sin(phi) w^2 / 8 + rise / 2).
// Within `margin` of the triangle n . u >= -|n| sin(margin). Where the line plus both allowances is negative,
// no direction of the turn is that near.
#pragma once

#include <array>
#include <cstddef>

#include "sphere/angular_box.hpp"
#include "sphere/triangle_cone.hpp"

namespace impinge {

class TurnClip {
 public:
  /// A part of a piece, in shares from 0 at its first border to 1 at its second; empty if from > to.
  struct Part {
    double from;  // share of the piece at which the part begins
    double to;    // and at which it ends
  };

  /// A turn between the outermost borders.
  struct Turn {
    CosSin polar;  // of the polar angle of its middle
    double rise;   // by which its polar angle rises, or more, radians
  };

  /// All in radians.
  struct Accuracy {
    double margin;   // how near to the triangle entries count
    double spacing;  // of turns, on which the number of pieces depends
    double doubt;    // bounds the error of an entry's direction
  };

  /// For the triangle `cone`, whose angular box (with the margin) is `box`.
  TurnClip(const TriangleCone& cone, const AngularBox& box, const Accuracy& accuracy);

  std::size_t pieces() const { return pieces_; }  // into which the azimuths of the box are divided
  /// Azimuth of border k = 0 ... pieces(), in turns.
  double azimuth(std::size_t k) const { return azimuth_ + static_cast<double>(k) * width_; }

  /// The part of the piece between borders k and k + 1 on which the turn may be near the triangle.
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
