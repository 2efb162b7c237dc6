// SPDX-License-Identifier: GPL-3.0-or-later
// USID: the thesis' spherical helix (Chapter 4), theta = 2 k phi (Eq. 9) with k turns and w = k^2 entries.
//
// Entries stand at equal steps of Eq. 10's travelled distance T = (4 k + 1) (1 - cos phi) / 2, which gives
// cos(phi_i) = 1 - 2 i / (w - 1). The factor 4 k + 1 then cancels, and the index T / dx of Section 4.3 is
// (w - 1) (1 - cos phi) / 2 exactly. T is not the arc length of the curve; entries at equal true arc length
// are another scheme. Lookup is Algorithm 3.
//
// A turn at the equator spans pi / k of phi, hence pi w / (2 k) = pi k / 2 entries: rounded up, the counts of
// Table 6. With 360 / p of them k = 2 (360 / p) / pi. Away from the poles w rho^2 = 4 + pi^2 / 4: half the
// diagonal of 4 / k along the curve by pi / k across.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "sphere/height_steps.hpp"
#include "sphere/scheme.hpp"
#include "sphere/spiral.hpp"

namespace impinge {

class Usid : public Spiral<HeightSteps> {
 public:
  static constexpr std::string_view name = "usid";
  static constexpr std::string_view label = "USID helix";
  static constexpr std::string_view citation =
      "thesis, Section 4.1-4.3, Eq. 9-10, Algorithm 3; Nishio, Altaf-Ul-Amin, Kurokawa & Kanaya 2006";

  Usid() : Usid(229) {}
  static Usid with_precision(double degrees);
  /// Of k turns and k^2 entries, 2 to 1000000 turns; std::invalid_argument else.
  static Usid with_turns(std::size_t turns);

  std::size_t helix_turns() const { return turns_; }  // k, from pole to pole
  std::size_t equator_points() const {
    return static_cast<std::size_t>(std::ceil(0.5 * kPi * static_cast<double>(turns_)));
  }
  double precision_deg() const { return 720.0 / (kPi * static_cast<double>(turns_)); }

  friend bool operator==(const Usid&, const Usid&) = default;

 private:
  static constexpr std::size_t kMostTurns =
      1'000'000;  // beyond them angles have too few digits to tell entries apart

  explicit Usid(std::size_t turns)
      : Spiral(HeightSteps(turns * turns, 2.0 * static_cast<double>(turns))), turns_(turns) {}

  std::size_t turns_;
};

inline Usid Usid::with_turns(std::size_t turns) {
  if (turns < 2) throw std::invalid_argument("a USID helix has at least 2 turns");
  if (turns > kMostTurns) throw std::invalid_argument("a USID helix has at most 1000000 turns");
  return Usid(turns);
}

inline Usid Usid::with_precision(double degrees) {
  if (!(degrees > 0.0 && degrees <= 90.0)) {
    throw std::invalid_argument("a USID precision is above 0 and at most 90 degrees");
  }
  const double turns = std::round(720.0 / (kPi * degrees));
  if (turns > static_cast<double>(kMostTurns)) {
    throw std::invalid_argument("a USID precision is at least 2.3e-4 degrees");
  }
  return with_turns(static_cast<std::size_t>(turns));
}

static_assert(SamplingScheme<Usid>);

}  // namespace impinge
