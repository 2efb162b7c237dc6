// SPDX-License-Identifier: GPL-3.0-or-later
// How far out the ball may reach in a direction u of its own frame, so that no required pose R brings it to
// the socket: E(u) = least of S(R u), S the radius of the socket's nearest layer, over the legs of the
// required motions (change/required_motion.hpp). And how far out the ball comes in a direction v of the
// socket's frame: F(v) = largest of B(R^T v), B the radius of the ball's farthest layer.
//
// Over a cap of directions. For every part of a leg, with R and rho its cap of poses, S is nowhere less than
// its least radius over the cap of rho + angle about R axis: the part with the least such end is halved,
// until it is narrower than the cap itself, or says enough. What it says holds for all parts, of which none
// has a smaller one. E is nowhere more than the largest radius over the cap of `angle` about R axis, for any
// R that was met on the way. F is the mirror image: its R^T turn directions by as much as R do, and the part
// with the largest end is halved. Theorem 17 (resection).
#pragma once

#include <span>
#include <vector>

#include "change/required_motion.hpp"
#include "gap/surface.hpp"
#include "rotations/radii_over_cap.hpp"

namespace impinge {

/// A number between two proven ends.
struct Ends {
  double low = 0.0;   // it is no less
  double high = 0.0;  // it is no more
};

class SweptRadius {
 public:
  /// E for a ball that is to be cut, F for a socket. other: the surface that is not cut, about the centre,
  /// mm, the socket in the joint frame, the ball in that of the legs; these are kept.
  SweptRadius(const TriangleMesh& other, std::vector<RequiredLeg> legs, Surface cut = Surface::ball);

  /// Ends of E, or F, over the cap, mm: no direction of it has a smaller one than `low`, none a larger one
  /// than `high`. Where nothing is met, E is infinite and F -infinity; where nothing is known, an end is. The
  /// end towards the centre of E is not refined beyond `enough`, mm, that away from it of F not below.
  Ends over(const DirectionCap& cap, double enough) const;

  Surface cut() const { return cut_; }                  // which of both is to be cut
  const RadiiOverCap& other() const { return other_; }  // radii of the one that is not

 private:
  double first_end(const DirectionCap& cap) const;
  double second_end(const DirectionCap& cap) const;
  Vec3 turned(const Vec3& u, const RotationBall& poses) const;

  Surface cut_;
  RadiiOverCap other_;
  std::vector<RequiredLeg> legs_;
};

}  // namespace impinge
