// SPDX-License-Identifier: GPL-3.0-or-later
// The placement (sphere/spiral.hpp) that Usid and HelixIsotropic share: w entries at equal steps of height,
// cos(phi_i) = 1 - 2 i / (w - 1), on the helix theta = slope * phi (thesis, Eq. 9, with slope = 2 k).
#pragma once

#include <cmath>
#include <cstddef>

#include "sphere/direction.hpp"
#include "sphere/haversine.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class HeightSteps {
 public:
  static constexpr bool kMirrored = true;  // the southern half is the mirror image of the northern one

  /// size >= 4 entries, below 2^53; slope >= 4, which makes two turns.
  HeightSteps(std::size_t size, double slope);

  double last() const { return last_; }          // place of the south pole
  double turns() const { return turns_; }        // turn of the south pole
  double slope() const { return 2.0 * turns_; }  // theta over phi

  double turn(double phi) const { return phi / spacing_; }
  double most_turn_rate() const { return 1.0 / spacing_; }
  double most_turn_bend() const { return 0.0; }
  double polar_of_turn(double turn) const { return turn * spacing_; }

  /// t(phi) = (w - 1) (1 - cos phi) / 2, and its inverse phi(t), accurate at both poles.
  double place(double phi) const { return last_ * haversine(phi); }
  double polar_angle(double t) const { return 2.0 * std::atan2(std::sqrt(t), std::sqrt(last_ - t)); }

  Vec3 direction(std::size_t entry) const;
  /// Fills a run whose `first` and `count` are set, with the numbers of direction().
  void fill(DirectionRun& run) const;

  /// Solid angle between the heights half a step to either side of an entry: 4 pi / (w - 1), at a pole half
  /// of that.
  double area(std::size_t entry) const {
    const bool pole = entry == 0 || static_cast<double>(entry) == last_;
    return (pole ? 2.0 : 4.0) * kPi / last_;
  }

  friend bool operator==(const HeightSteps&, const HeightSteps&) = default;

  /// The numbers of a helix that direction() needs.
  struct Curve {
    double last;  // place of the south pole
    double end;   // fraction of a turn at which the helix meets the south pole
    double high;  // turns for each unit of phi / 2, 26 bits
    double low;   // and the rest
    friend bool operator==(const Curve&, const Curve&) = default;
  };

 private:
  double last_;
  double turns_;
  double spacing_;  // of two turns, radians
  Curve curve_;
};

}  // namespace impinge
