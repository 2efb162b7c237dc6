// SPDX-License-Identifier: GPL-3.0-or-later
// The length E(x | m) of an elliptic arc as a function of x, and x as a function of the length, fast.
#pragma once

#include <memory>

#include "sphere/smooth_table.hpp"

namespace impinge {

/// The arc from x = 0 to `end`, on which the length grows with the speed sqrt(cos^2 x + complement sin^2 x),
/// complement = 1 - m > 0. `end` is at most pi / 2 if the speed rises, complement >= 1. If it falls, `end` is
/// at most pi / 4: beyond, the speed may come so near to 0 that the length no longer determines x. Both
/// functions have a relative error of about 1e-15. A copy shares the tables of the original.
class EllipticArc {
 public:
  EllipticArc(double complement, double end);  // makes the tables

  double length() const { return length_; }                        // of the whole arc
  double length(double x) const { return x * (*mean_speed_)(x); }  // from 0 to x in [0, end]
  /// The x at a length in [0, length()].
  double angle(double length) const { return length * (*mean_slowness_)(length); }

 private:
  double length_;
  std::shared_ptr<const SmoothTable> mean_speed_;     // length over x
  std::shared_ptr<const SmoothTable> mean_slowness_;  // x over length
};

/// x with E(x | 1 - complement) = length, at most `end`.
double elliptic_angle(double length, double complement, double end);

}  // namespace impinge
