// SPDX-License-Identifier: GPL-3.0-or-later
// A placement for Spiral (sphere/spiral.hpp) that is uniform on the surface of the rotational conchoid r = a
// + b cos(phi). Entries stand at equal steps of area A(phi), on turns at equal distances h along the
// meridian, whose length is s(phi):
//   A(phi_i) = A(pi) i / (w - 1),   theta_i = 2 pi s(phi_i) / h,   h^2 = A(pi) / w,
// so that entries are as far apart along a turn as turns are. With b = 0 this is the isotropic helix.
#pragma once

#include <cstddef>

#include "sphere/conchoid_cap.hpp"
#include "sphere/conchoid_shape.hpp"
#include "sphere/direction.hpp"

namespace impinge {

class ConchoidSteps {
 public:
  static constexpr bool kMirrored = false;

  /// 0 <= b < a, size >= 6 entries and so many that there are two turns.
  ConchoidSteps(const ConchoidShape& shape, std::size_t size);

  double last() const { return last_; }
  double turns() const { return north_turns_ + south_turns_; }
  double spacing() const { return spacing_; }  // h, in units of a
  double ratio() const { return b_; }          // b / a
  double step_area() const { return step_; }   // between entries, in units of a^2
  double turn(double phi) const;
  /// The turn is s / h. With s' = m, m^2 = 1 + b^2 + 2 b cos(phi), |s'| is at most 1 + b, and |s''| = b
  /// sin(phi) / m is largest, b, where cos(phi) = -b.
  double most_turn_rate() const { return (1.0 + b_) / spacing_; }
  double most_turn_bend() const { return b_ / spacing_; }
  double polar_of_turn(double turn) const;
  double place(double phi) const;
  double polar_angle(double t) const;

  Vec3 direction(std::size_t entry) const;

  friend bool operator==(const ConchoidSteps& a, const ConchoidSteps& b) {
    return a.last_ == b.last_ && a.b_ == b.b_;
  }

 private:
  /// A place as seen from the pole of its hemisphere: which pole, and sin^2 of half the angle from there.
  struct Seen {
    bool south;
    double y;
  };
  Seen seen(double t) const;

  double last_;
  double b_;  // in units of a
  ConchoidCap north_;
  ConchoidCap south_;
  double step_;  // area between entries
  double spacing_;
  double north_places_;  // places from the north pole to phi = pi / 2; turns likewise
  double north_turns_;
  double south_turns_;
};

}  // namespace impinge
