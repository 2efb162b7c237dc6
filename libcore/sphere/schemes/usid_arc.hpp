// SPDX-License-Identifier: GPL-3.0-or-later
// USID by the other reading of Eq. 9 and 10: k turns and w = k^2 entries "equally distributed along the
// curve" (Section 4.3), equal steps of its true arc length L(phi) = E(phi | m = -4 k^2).
//
// Usid has them at equal steps of Eq. 10's travelled distance T = (4 k + 1) (1 - cos phi) / 2, with which the
// look-up by T is exact; here the look-up, Algorithm 3, takes the true place (w - 1) L(phi) / L(pi). What the
// thesis' own look-up by T makes of such entries is stencil_by_travelled_distance(): for an experiment.
//
// Turns are pi / k apart and entries L(pi) / (w - 1), near to 4 / k, along the curve: away from the poles
// w rho^2 = 4 + pi^2 / 4 as in Usid.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "sphere/arc_steps.hpp"
#include "sphere/haversine.hpp"
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

  /// Index T / dx of Section 4.3 with the true spacing dx = L(pi) / (w - 1), clamped to the table.
  double place_by_travelled_distance(double phi) const {
    const double travelled = (4.0 * static_cast<double>(helix_turns()) + 1.0) * haversine(phi);
    return std::min(travelled / placement().length(), 1.0) * placement().last();
  }

  /// Algorithm 3 with that index: as the thesis has it, and wrong by up to 0.25 k entries, for T is not the
  /// arc length. Taps may be far outside of the stencil radius.
  Stencil stencil_by_travelled_distance(const Vec3& x) const {
    return stencil_with(x, [this](double phi) { return place_by_travelled_distance(phi); });
  }

  friend bool operator==(const UsidArc&, const UsidArc&) = default;

 private:
  friend TurnsHelix;
  explicit UsidArc(std::size_t turns) : TurnsHelix(turns, ArcSteps(turns * turns, turns)) {}
};

static_assert(SamplingScheme<UsidArc>);

}  // namespace impinge
