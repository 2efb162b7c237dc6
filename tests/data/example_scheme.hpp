// SPDX-License-Identifier: GPL-3.0-or-later
// An example to begin from: latitude rings with equally many entries each, and one entry a pole.
//
// n + 1 rings at phi = 180 k / n degrees; the first and the last are the poles, one entry each, the others
// have 2 n entries at theta = 180 t / n degrees: 2 n (n - 1) + 2 entries, numbered ring by ring from the
// north. This is the thesis' grid (schemes/rsid.hpp) with each pole stored once: N rho^2 -> pi^2, from the
// square cells at the equator. Lookup is bilinear in (phi, theta), with three taps beside a pole.
//
// Copied to libcore/sphere/schemes/ it is in every experiment, test, plot and table. The class has
// the file's name with a capital for each word: ExampleScheme in example_scheme.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "sphere/arc_borders.hpp"
#include "sphere/circumradius.hpp"
#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/ring_walker.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class ExampleScheme {
 public:
  static constexpr std::string_view name = "example_scheme";           // as in file names and CSVs
  static constexpr std::string_view label = "Example scheme";          // as in legends
  static constexpr std::string_view citation = "thesis, Section 3.1";  // as in the paper's table

  // A default, and one for a spacing at the equator. std::invalid_argument where there is none.
  ExampleScheme() = default;
  static ExampleScheme with_precision(double degrees) {
    return ExampleScheme(std::max<std::size_t>(equator_division(degrees, 180.0, label), 2));
  }

  std::size_t size() const { return 2 * n_ * (n_ - 1) + 2; }
  std::size_t cells() const { return 2 * n_ * n_; }
  std::size_t equator_points() const { return 2 * n_; }
  double precision_deg() const { return 180.0 / static_cast<double>(n_); }

  Vec3 direction(std::size_t entry) const {
    const Ring on = ring((entry + 2 * n_ - 1) / (2 * n_));
    return on.direction(entry - on.first);
  }

  // Four corners of a cell; beside a pole two of them are the same entry and make one tap.
  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const std::size_t k = std::min(static_cast<std::size_t>(phi / step()), n_ - 1);
    const std::size_t t = std::min(static_cast<std::size_t>(theta / step()), 2 * n_ - 1);
    const double down = std::min(phi / step() - static_cast<double>(k), 1.0);
    const double right = std::min(theta / step() - static_cast<double>(t), 1.0);
    const std::size_t cell = k * 2 * n_ + t;
    const auto at = [this](std::size_t ring, std::size_t place) {
      return 1 + (ring - 1) * 2 * n_ + place % (2 * n_);
    };
    const double up = 1.0 - down;
    const double left = 1.0 - right;
    if (k == 0) return {{0, at(1, t), at(1, t + 1), 0}, {up, down * left, down * right, 0.0}, 3, cell};
    if (k == n_ - 1)
      return {{at(k, t), at(k, t + 1), size() - 1, 0}, {up * left, up * right, down, 0.0}, 3, cell};
    return {{at(k, t), at(k, t + 1), at(k + 1, t), at(k + 1, t + 1)},
            {up * left, up * right, down * left, down * right},
            4,
            cell};
  }

  // Circumradius of the widest cell, the one at the equator.
  double covering_radius() const {
    const Ring lower = ring((n_ + 1) / 2);
    return circumradius(lower.direction(0), lower.direction(1), ring((n_ - 1) / 2).direction(0));
  }

  // The far corner of a cell: no farther than its diagonal, sides of a step and at most that.
  double stencil_radius() const { return std::sqrt(2.0) * step(); }

  // The walker of all schemes that stand on rings, which asks for the three members below.
  RingWalker<ExampleScheme> walker() const { return RingWalker(*this); }
  std::size_t rings() const { return n_ + 1; }
  Ring ring(std::size_t k) const {
    const CosSin polar = half_turn_fraction(static_cast<long>(k), static_cast<long>(n_));
    if (k == 0) return {0, 1, 0, polar};
    if (k == n_) return {size() - 1, 1, 0, polar};
    return {1 + (k - 1) * 2 * n_, 2 * n_, 0, polar};
  }
  double ring_position(double phi) const { return phi / step(); }

  // Optional, see AreaScheme: the share of the band half a step either way of the ring.
  double area(std::size_t entry) const {
    if (entry == 0 || entry == size() - 1) return 2.0 * kPi * (1.0 - std::cos(0.5 * step()));
    const Ring on = ring((entry + 2 * n_ - 1) / (2 * n_));
    return 2.0 * step() * on.polar.sin * std::sin(0.5 * step());
  }

  // Optional, see HasKnownBorders: cells lie between parallels and meridians.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return latitude_is_monotone(a, b); }

  friend bool operator==(const ExampleScheme&, const ExampleScheme&) = default;

 private:
  explicit ExampleScheme(std::size_t n) : n_(n) {}

  double step() const { return kPi / static_cast<double>(n_); }  // radians

  std::size_t n_ = 180;
};

static_assert(SamplingScheme<ExampleScheme>);

}  // namespace impinge
