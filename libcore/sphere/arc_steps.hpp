// SPDX-License-Identifier: GPL-3.0-or-later
// A placement for Spiral (sphere/spiral.hpp): w entries at equal steps of true arc length on the helix
// theta = 2 k phi (thesis, Eq. 9). The length up to phi is
//   L(phi) = integral_0^phi sqrt(1 + 4 k^2 sin^2 t) dt = E(phi | m = -4 k^2),
// and the place there is t(phi) = (w - 1) L(phi) / L(pi).
#pragma once

#include <cstddef>

#include "sphere/direction.hpp"
#include "sphere/elliptic_arc.hpp"

namespace impinge {

class ArcSteps {
 public:
  static constexpr bool kMirrored = true;

  /// size >= 4 entries, below 2^53; turns >= 2.
  ArcSteps(std::size_t size, std::size_t turns);

  double last() const { return last_; }
  double turns() const { return turns_; }
  double turn(double phi) const { return phi / spacing_; }
  double most_turn_rate() const { return 1.0 / spacing_; }
  double most_turn_bend() const { return 0.0; }
  double polar_of_turn(double turn) const { return turn * spacing_; }
  double place(double phi) const;
  double polar_angle(double t) const;

  double length() const { return 2.0 * northern_.length(); }  // L(pi), on the unit sphere

  Vec3 direction(std::size_t entry) const;

  friend bool operator==(const ArcSteps& a, const ArcSteps& b) {
    return a.last_ == b.last_ && a.turns_ == b.turns_;
  }

 private:
  double last_;
  double turns_;
  double spacing_;  // of two turns, radians
  EllipticArc northern_;
  double step_;  // of length between entries
};

}  // namespace impinge
