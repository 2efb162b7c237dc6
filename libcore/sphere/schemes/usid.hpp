// SPDX-License-Identifier: GPL-3.0-or-later
// USID: the thesis' spherical helix (Chapter 4), theta = 2 k phi (Eq. 9) with k turns and w = k^2 entries.
//
// Entries stand at equal steps of Eq. 10's travelled distance T = (4 k + 1) (1 - cos phi) / 2, which gives
// cos(phi_i) = 1 - 2 i / (w - 1). The factor 4 k + 1 then cancels, and the index T / dx of Section 4.3 is
// (w - 1) (1 - cos phi) / 2 exactly. T is not the arc length of the curve; entries at equal true arc length
// are another scheme. Lookup is Algorithm 3.
//
// Away from the poles w rho^2 = 4 + pi^2 / 4: rho is half the diagonal of a rectangle, 4 / k along the curve
// by pi / k across.
#pragma once

#include <cstddef>
#include <string_view>

#include "sphere/height_steps.hpp"
#include "sphere/scheme.hpp"
#include "sphere/turns_helix.hpp"

namespace impinge {

class Usid : public TurnsHelix<Usid, HeightSteps> {
 public:
  static constexpr std::string_view name = "usid";
  static constexpr std::string_view label = "USID helix";
  static constexpr std::string_view citation =
      "thesis, Section 4.1-4.3, Eq. 9-10, Algorithm 3; Nishio, Altaf-Ul-Amin, Kurokawa & Kanaya 2006";

  Usid() : Usid(kDefaultTurns) {}

  friend bool operator==(const Usid&, const Usid&) = default;

 private:
  friend TurnsHelix;
  explicit Usid(std::size_t turns)
      : TurnsHelix(turns, HeightSteps(turns * turns, 2.0 * static_cast<double>(turns))) {}
};

static_assert(SamplingScheme<Usid>);

}  // namespace impinge
