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
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "sphere/arc_steps.hpp"
#include "sphere/haversine.hpp"
#include "sphere/scheme.hpp"
#include "sphere/spiral.hpp"

namespace impinge {

class UsidArc : public Spiral<ArcSteps> {
 public:
  static constexpr std::string_view name = "usid_arc";
  static constexpr std::string_view label = "USID helix, true arc";
  static constexpr std::string_view citation =
      "thesis, Section 4.1-4.3, Eq. 9, Algorithm 3; arc length by Carlson 1995, doi:10.1007/BF02198293";

  UsidArc() : UsidArc(229) {}
  static UsidArc with_precision(double degrees);
  /// Of k turns and k^2 entries, 2 to 1000000 turns; std::invalid_argument else.
  static UsidArc with_turns(std::size_t turns);

  std::size_t helix_turns() const { return turns_; }  // k, from pole to pole
  std::size_t equator_points() const {
    return static_cast<std::size_t>(std::ceil(0.5 * kPi * static_cast<double>(turns_)));
  }
  double precision_deg() const { return 720.0 / (kPi * static_cast<double>(turns_)); }

  /// Index T / dx of Section 4.3 with the true spacing dx = L(pi) / (w - 1), clamped to the table.
  double place_by_travelled_distance(double phi) const {
    const double travelled = (4.0 * static_cast<double>(turns_) + 1.0) * haversine(phi);
    return std::min(travelled / placement().length(), 1.0) * placement().last();
  }

  /// Algorithm 3 with that index: as the thesis has it, and wrong by up to 0.25 k entries, for T is not the
  /// arc length. Taps may be far outside of the stencil radius.
  Stencil stencil_by_travelled_distance(const Vec3& x) const {
    return stencil_with(x, [this](double phi) { return place_by_travelled_distance(phi); });
  }

  friend bool operator==(const UsidArc&, const UsidArc&) = default;

 private:
  static constexpr std::size_t kMostTurns =
      1'000'000;  // beyond them angles have too few digits to tell entries apart

  explicit UsidArc(std::size_t turns) : Spiral(ArcSteps(turns * turns, turns)), turns_(turns) {}

  std::size_t turns_;
};

inline UsidArc UsidArc::with_turns(std::size_t turns) {
  if (turns < 2) throw std::invalid_argument("a USID helix has at least 2 turns");
  if (turns > kMostTurns) throw std::invalid_argument("a USID helix has at most 1000000 turns");
  return UsidArc(turns);
}

inline UsidArc UsidArc::with_precision(double degrees) {
  if (!(degrees > 0.0 && degrees <= 90.0)) {
    throw std::invalid_argument("a USID precision is above 0 and at most 90 degrees");
  }
  const double turns = std::round(720.0 / (kPi * degrees));
  if (turns > static_cast<double>(kMostTurns)) {
    throw std::invalid_argument("a USID precision is at least 2.3e-4 degrees");
  }
  return with_turns(static_cast<std::size_t>(turns));
}

static_assert(SamplingScheme<UsidArc>);

}  // namespace impinge
