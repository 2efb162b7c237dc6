// SPDX-License-Identifier: GPL-3.0-or-later
// How far out may the ball reach in a direction u of its own frame, so that no required pose R brings it to
// the socket? E(u) is the least S(R u) over the required motions (change/required_motion.hpp), S the radius
// of the socket's nearest layer. And how far out does the ball come in a direction v of the socket's frame?
// F(v) is the largest B(R^T v), B the radius of the ball's farthest layer. Theorem 17 (resection).
#pragma once

#include <span>
#include <vector>

#include "change/required_motion.hpp"
#include "gap/surface.hpp"
#include "rotations/radii_over_cap.hpp"

namespace impinge {

/// A number between two proven ends.
struct Ends {
  double low = 0.0;   // the number is no less
  double high = 0.0;  // the number is no more
};

class SweptRadius {
 public:
  /// E for a ball that is to be cut, F for a socket. `other` is the surface that is not cut, about the
  /// centre, mm: a socket in the joint frame, a ball in the frame of the legs.
  SweptRadius(const TriangleMesh& other, std::vector<RequiredLeg> legs, Surface cut = Surface::ball);

  /// Ends of E, or F, over the cap, mm: no direction of the cap has less than `low` or more than `high`.
  /// Where nothing is met, E is infinite and F -infinity. An end of which nothing is known is infinite too.
  /// Refinement stops once the low end of E is `enough` mm or more, or the high end of F `enough` or less.
  Ends over(const DirectionCap& cap, double enough) const;

  Surface cut() const { return cut_; }                  // the surface that is to be cut
  const RadiiOverCap& other() const { return other_; }  // radii of the other one

 private:
  double first_end(const DirectionCap& cap) const;
  double second_end(const DirectionCap& cap) const;
  Vec3 turned(const Vec3& u, const RotationBall& poses) const;

  Surface cut_;
  RadiiOverCap other_;
  std::vector<RequiredLeg> legs_;
};

}  // namespace impinge
