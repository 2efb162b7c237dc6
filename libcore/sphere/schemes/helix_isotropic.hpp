// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic helix, the generalised spiral: entries are as far apart along the curve as its turns are, with N
// entries 2 sqrt(pi / N) radians.
//
// theta = sqrt(pi N) phi (Bauer 2000), that is 2 k = sqrt(pi w) in Eq. 9 of the thesis, where k = sqrt(w)
// leaves the entries 4 / pi times as far apart along the curve as across it. Heights are as in Rakhmanov,
// Saff & Zhou 1994, cos(phi_i) = 1 - 2 i / (N - 1), which put an entry on each pole as in Usid, so that one
// lookup serves both; Bauer's own are half a step inside, 1 - (2 i + 1) / N. Away from the poles
// N rho^2 = 2 pi: half the diagonal of a square of 2 sqrt(pi / N).
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "sphere/height_steps.hpp"
#include "sphere/scheme.hpp"
#include "sphere/spiral.hpp"

namespace impinge {

class HelixIsotropic : public Spiral<HeightSteps> {
 public:
  static constexpr std::string_view name = "helix_isotropic";
  static constexpr std::string_view label = "Isotropic helix";
  static constexpr std::string_view citation =
      "Bauer 2000, doi:10.2514/2.4497; Rakhmanov, Saff & Zhou 1994, Math. Res. Lett. 1";

  HelixIsotropic() : HelixIsotropic(41253) {}
  static HelixIsotropic with_precision(double degrees);

  /// Entries of the turn round the equator: 2 pi over the spacing.
  std::size_t equator_points() const { return static_cast<std::size_t>(std::round(placement().slope())); }
  double precision_deg() const { return 360.0 / placement().slope(); }

  friend bool operator==(const HelixIsotropic&, const HelixIsotropic&) = default;

 private:
  static constexpr double kMostEntries =
      1e12;  // beyond them angles have too few digits to tell entries apart

  explicit HelixIsotropic(std::size_t size)
      : Spiral(HeightSteps(size, std::sqrt(kPi * static_cast<double>(size)))) {}
};

inline HelixIsotropic HelixIsotropic::with_precision(double degrees) {
  if (!(degrees > 0.0 && degrees <= 90.0)) {
    throw std::invalid_argument("an isotropic helix has a precision above 0 and at most 90 degrees");
  }
  const double spacing = degrees * kDegree;
  const double size = std::round(4.0 * kPi / spacing / spacing);
  if (!(size <= kMostEntries)) {
    throw std::invalid_argument("an isotropic helix has a precision of at least 2.1e-4 degrees");
  }
  return HelixIsotropic(static_cast<std::size_t>(size));
}

static_assert(SamplingScheme<HelixIsotropic>);

}  // namespace impinge
