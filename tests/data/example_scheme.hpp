// SPDX-License-Identifier: GPL-3.0-or-later
// An example to begin from: latitude rings with equally many entries each, and one entry a pole.
//
// n + 1 rings at phi = 180 k / n degrees; the first and the last are the poles, one entry each, the others
// have 2 n entries at theta = 180 t / n degrees: 2 n (n - 1) + 2 entries, numbered ring by ring from the
// north. This is the thesis' grid (schemes/rsid.hpp) with each pole stored once: N rho^2 -> pi^2, from the
// square cells at the equator. Lookup is bilinear in (phi, theta).
//
// Copied to libcore/sphere/schemes/ it is in every experiment, test, plot and table. The class has the file's
// name with a capital for each word: ExampleScheme in example_scheme.hpp. What more a scheme may tell, for
// speed and for tighter bounds, is in sphere/schemes/README.md; without it all the same holds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class ExampleScheme {
 public:
  static constexpr std::string_view name = "example_scheme";           // as in file names and CSVs
  static constexpr std::string_view label = "Example scheme";          // as in legends
  static constexpr std::string_view citation = "thesis, Section 3.1";  // as in the papers' table

  // A default, and one for a spacing at the equator. std::invalid_argument where there is none.
  ExampleScheme() = default;
  static ExampleScheme with_precision(double degrees) {
    return ExampleScheme(std::max<std::size_t>(equator_division(degrees, 180.0, label), 2));
  }
  double precision_deg() const { return 180.0 / static_cast<double>(n_); }

  std::size_t size() const { return 2 * n_ * (n_ - 1) + 2; }
  std::size_t cells() const { return 2 * n_ * n_; }
  std::size_t equator_points() const { return 2 * n_; }

  Vec3 direction(std::size_t entry) const {
    const std::size_t shifted = entry + 2 * n_ - 1;  // as if the north pole were the last of 2 n
    const CosSin phi = half_turn_fraction(static_cast<long>(shifted / (2 * n_)), static_cast<long>(n_));
    const CosSin theta = half_turn_fraction(static_cast<long>(shifted % (2 * n_)), static_cast<long>(n_));
    return {phi.sin * theta.cos, phi.sin * theta.sin, phi.cos};
  }

  // Four corners of a cell; beside a pole two of them are the same entry.
  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const std::size_t k = std::min(static_cast<std::size_t>(phi / step()), n_ - 1);
    const std::size_t t = std::min(static_cast<std::size_t>(theta / step()), 2 * n_ - 1);
    const double down = std::min(phi / step() - static_cast<double>(k), 1.0);
    const double right = std::min(theta / step() - static_cast<double>(t), 1.0);
    return {{at(k, t), at(k, t + 1), at(k + 1, t), at(k + 1, t + 1)},
            {(1.0 - down) * (1.0 - right), (1.0 - down) * right, down * (1.0 - right), down * right},
            4,
            k * 2 * n_ + t};
  }

  // Circumradius of the widest cell, the one at the equator.
  double covering_radius() const {
    const std::size_t k = (n_ + 1) / 2;
    return circumradius(direction(at(k, 0)), direction(at(k, 1)), direction(at((n_ - 1) / 2, 0)));
  }
  // The far corner of a cell: no farther than its diagonal, sides of a step and at most that.
  double stencil_radius() const { return std::sqrt(2.0) * step(); }

  friend bool operator==(const ExampleScheme&, const ExampleScheme&) = default;

 private:
  explicit ExampleScheme(std::size_t n) : n_(n) {}

  double step() const { return kPi / static_cast<double>(n_); }  // radians
  std::size_t at(std::size_t ring, std::size_t t) const {
    return ring == 0 ? 0 : ring == n_ ? size() - 1 : 1 + (ring - 1) * 2 * n_ + t % (2 * n_);
  }

  std::size_t n_ = 180;
};

static_assert(SamplingScheme<ExampleScheme>);

}  // namespace impinge
