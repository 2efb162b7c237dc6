// SPDX-License-Identifier: GPL-3.0-or-later
// USID by the other reading of Eq. 9 and 10: k turns and w = k^2 entries "equally distributed along the
// curve" (Section 4.3), at equal steps of its true arc length L(phi) = E(phi | m = -4 k^2).
//
// Usid has its entries at equal steps of Eq. 10's travelled distance T = (4 k + 1) (1 - cos phi) / 2, so that
// its look-up by T is exact. Here the look-up, Algorithm 3, uses the true place (w - 1) L(phi) / L(pi).
//
// Turns are pi / k apart and entries L(pi) / (w - 1), near to 4 / k, along the curve: away from the poles
// w rho^2 = 4 + pi^2 / 4 as in Usid.
#pragma once

#include <cstddef>
#include <string_view>

#include "sphere/arc_steps.hpp"
#include "sphere/scheme.hpp"
#include "sphere/turns_helix.hpp"

namespace impinge {

class UsidArc : public TurnsHelix<UsidArc, ArcSteps> {
 public:
  static constexpr std::string_view name = "usid_arc";
  static constexpr std::string_view label = "USID helix, true arc";
  static constexpr std::string_view citation =
      "thesis, Section 4.1-4.3, Eq. 9, Algorithm 3; arc length by Carlson 1995, doi:10.1007/BF02198293";

  UsidArc() : UsidArc(kDefaultTurns) {}

  friend bool operator==(const UsidArc&, const UsidArc&) = default;

 private:
  friend TurnsHelix;
  explicit UsidArc(std::size_t turns) : TurnsHelix(turns, ArcSteps(turns * turns, turns)) {}
};

static_assert(SamplingScheme<UsidArc>);

}  // namespace impinge
