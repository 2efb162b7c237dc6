// SPDX-License-Identifier: GPL-3.0-or-later
// What Usid and UsidArc share: the thesis' helix theta = 2 k phi (Eq. 9) with k turns and w = k^2 entries,
// wherever on it they stand.
//
// A turn at the equator spans pi / k of phi, hence pi w / (2 k) = pi k / 2 entries: rounded up, the counts of
// Table 6. With 360 / p of them k = 2 (360 / p) / pi.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "sphere/spiral.hpp"

namespace impinge {

/// Base of such a scheme S, whose entries stand on the placement P (sphere/spiral.hpp).
template <class S, class P>
class TurnsHelix : public Spiral<P> {
 public:
  /// The scheme whose entries are about `degrees` apart along the equator. Throws std::invalid_argument above
  /// 90 and below 2.3e-4 degrees.
  static S with_precision(double degrees) {
    if (!(degrees > 0.0 && degrees <= 90.0))
      throw std::invalid_argument("a USID precision is above 0 and at most 90 degrees");
    const double turns = std::round(720.0 / (kPi * degrees));
    if (turns > static_cast<double>(kMostTurns))
      throw std::invalid_argument("a USID precision is at least 2.3e-4 degrees");
    return with_turns(static_cast<std::size_t>(turns));
  }
  /// The scheme with k turns and k^2 entries. Throws std::invalid_argument unless k is 2 to 1000000.
  static S with_turns(std::size_t turns) {
    if (turns < 2) throw std::invalid_argument("a USID helix has at least 2 turns");
    if (turns > kMostTurns) throw std::invalid_argument("a USID helix has at most 1000000 turns");
    return S(turns);
  }

  std::size_t helix_turns() const { return turns_; }  // k, from pole to pole
  std::size_t equator_points() const {
    return static_cast<std::size_t>(std::ceil(0.5 * kPi * static_cast<double>(turns_)));
  }
  double precision_deg() const { return 720.0 / (kPi * static_cast<double>(turns_)); }

  friend bool operator==(const TurnsHelix&, const TurnsHelix&) = default;

 protected:
  static constexpr std::size_t kDefaultTurns = 229;  // 1 degree

  TurnsHelix(std::size_t turns, const P& placement) : Spiral<P>(placement), turns_(turns) {}

 private:
  static constexpr std::size_t kMostTurns =
      1'000'000;  // beyond them angles have too few digits to tell entries apart

  std::size_t turns_;
};

}  // namespace impinge
