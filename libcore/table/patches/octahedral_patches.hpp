// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of the octahedral equal-area map: s and t are u and v in the square of a quarter; `part` is the
// quarter.
//
// North of the fold u + v = n, with m = u + v and r = m / n:
//   phi = 2 asin(r / sqrt(2)),  dphi/dr = g = sqrt(2) / sqrt(1 - r^2 / 2),  d^2phi/dr^2 = g r / (2 - r^2)
//   theta = (pi / 2) v / m,     |dtheta/du| <= pi / (2 m),  |d^2theta/du^2| <= pi / m^2
//   sin(phi) = r sqrt(2 - r^2) <= sqrt(2) m / n
// So, with q = v / m <= 1 for steps of u and q = u / m for steps of v,
//   way^2  = (g / n)^2 + (pi q / (sqrt(2) n))^2
//   turn   = hypot(g r / ((2 - r^2) n^2) + pi^2 q^2 / (2 sqrt(2) n m),
//                  pi sqrt(2) q / (n m) + pi g q / (n m)),
// without a bound at the pole, m = 0. The south mirrors this. At the fold dtheta/du jumps by
// pi |n - 2 v| / (2 n^2) <= pi / (2 n).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/schemes/octahedral_equal_area.hpp"
#include "table/patches/patch.hpp"

namespace impinge {

class OctahedralPatches {
 public:
  explicit OctahedralPatches(std::size_t divisions) : n_(divisions) {}  // of the map with n divisions

  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      for (std::size_t j = 0; j < n_; ++j) {
        for (std::size_t i = 0; i < n_; ++i) {
          const auto u = static_cast<double>(i);
          const auto v = static_cast<double>(j);
          visit(Patch{quarter, {{u, v}, {u + 1.0, v + 1.0}}});
        }
      }
    }
  }

  Vec3 at(const Patch& patch, double u, double v) const {
    const auto n = static_cast<double>(n_);
    const bool north = u + v <= n;
    const double along = north ? u : n - v;
    const double across = north ? v : n - u;
    const double m = along + across;
    const double share = m > 0.0 ? across / m : 0.0;
    const double from_pole = 2.0 * std::asin(std::min(m / n * std::sqrt(0.5), 1.0));
    const double theta = 0.5 * kPi * (static_cast<double>(patch.part) + share);
    return to_direction({north ? from_pole : kPi - from_pole, theta});
  }

  PatchMotion motion(const Patch&, const Rect& rect) const {
    const auto n = static_cast<double>(n_);
    const double low = rect.from[0] + rect.from[1];
    const double high = rect.to[0] + rect.to[1];
    const bool folded = low < n && high > n;
    const double least = std::min(low, 2.0 * n - high);  // m
    const double r = folded ? 1.0 : std::min(1.0, (high <= n ? high : 2.0 * n - low) / n);
    const double g = std::sqrt(2.0 / (1.0 - 0.5 * r * r));
    PatchMotion motion;
    motion.smooth = least > 0.0;
    const double east = kPi * std::sqrt(2.0) / (n * least) + kPi * g / (n * least);
    const double south = g * r / ((2.0 - r * r) * n * n) + kPi * kPi / (2.0 * std::sqrt(2.0) * n * least);
    for (std::size_t k = 0; k < 2; ++k) {
      const double h = rect.width(k);
      motion.way[k] = h * std::hypot(g, kPi / std::sqrt(2.0)) / n;
      motion.turn[k] = motion.smooth ? h * h * std::hypot(south, east) : 0.0;
      motion.kink[k] = folded ? h * kPi / (2.0 * n) : 0.0;
    }
    return motion;
  }

 private:
  std::size_t n_;
};

inline OctahedralPatches patches_of(const OctahedralEqualArea& scheme) {
  return OctahedralPatches(scheme.divisions());
}

}  // namespace impinge
