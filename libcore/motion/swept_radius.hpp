// SPDX-License-Identifier: GPL-3.0-or-later
// How far out the ball may reach in a direction u of its own frame, so that no required pose R brings it to
// the socket: E(u) = least of S(R u), S the radius of the socket's nearest layer, over the legs of the
// required motions (motion/required_motion.hpp).
//
// Over a cap of directions. For every part of a leg, with R and rho its cap of poses, S is nowhere less than
// its least radius over the cap of rho + angle about R axis: the part with the least such end is halved,
// until it is narrower than the cap itself, or says enough. What it says holds for all parts, of which none
// has a smaller one. E is nowhere more than the largest radius over the cap of `angle` about R axis, for any
// R that was met on the way.
#pragma once

#include <span>
#include <vector>

#include "motion/radii_over_cap.hpp"
#include "motion/required_motion.hpp"

namespace impinge {

/// A number between two proven ends.
struct Ends {
  double low = 0.0;   // it is no less
  double high = 0.0;  // it is no more
};

class SweptRadius {
 public:
  /// socket in the joint frame about the centre, mm; the legs are kept.
  SweptRadius(const TriangleMesh& socket, std::vector<RequiredLeg> legs);

  /// Ends of E over the cap, mm: no direction of it has a smaller E than `low`, none a larger one than
  /// `high`; infinite where nothing is met, or nothing is known. `low` is not refined beyond `enough`, mm.
  Ends over(const DirectionCap& cap, double enough) const;

  const RadiiOverCap& socket() const { return socket_; }  // its radii, joint frame

 private:
  RadiiOverCap socket_;
  std::vector<RequiredLeg> legs_;
};

}  // namespace impinge
