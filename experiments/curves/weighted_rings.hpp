// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' weighted sampling (Section 5.1.2, Eq. 16) as a sampling scheme. It is a grid of angles whose
// rings from the apex phi = 0 to the rim at 90 degrees cut the meridian of the conchoid into equal lengths:
//   phi_i = 2 asin(i sin(45 degrees) / n), i = 0 .. n,
// which is Eq. 16 without its rounded constants. The other half of the sphere, which the thesis does not
// sample, mirrors them. Precision p gives n = 90 / p segments and 360 / p columns, as many entries as the
// grid has. A look-up is linear in theta, and in phi between two rings.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/scheme.hpp"

namespace impinge::lab {

class WeightedRings {
 public:
  static constexpr std::string_view name = "weighted_rings";
  static constexpr std::string_view label = "Grid, weighted";
  static constexpr std::string_view citation = "thesis, Section 5.1.2, Eq. 16";

  WeightedRings() = default;
  // Entries at most so many degrees apart. Throws std::invalid_argument as equator_division().
  static WeightedRings with_precision(double degrees) {
    return WeightedRings(equator_division(degrees, 90.0, label));
  }
  double precision_deg() const { return 90.0 / static_cast<double>(n_); }

  std::size_t columns() const { return 4 * n_; }
  std::size_t size() const { return (2 * n_ + 1) * columns(); }
  std::size_t cells() const { return 2 * n_ * columns(); }
  std::size_t equator_points() const { return columns(); }

  // Polar angle of a ring, radians.
  double ring(std::size_t i) const { return i <= n_ ? upper(i) : kPi - upper(2 * n_ - i); }

  Vec3 direction(std::size_t entry) const {
    const double theta = 2.0 * kPi * static_cast<double>(entry % columns()) / static_cast<double>(columns());
    return to_direction({ring(entry / columns()), theta});
  }

  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const double place =
        std::sin(0.5 * std::min(phi, kPi - phi)) / std::sin(0.25 * kPi) * static_cast<double>(n_);
    const double count = phi <= 0.5 * kPi ? place : static_cast<double>(2 * n_) - place;
    const std::size_t i = std::min(static_cast<std::size_t>(count), 2 * n_ - 1);
    const double column = theta / (2.0 * kPi) * static_cast<double>(columns());
    const std::size_t j = std::min(static_cast<std::size_t>(column), columns() - 1);
    const std::size_t right = j + 1 == columns() ? 0 : j + 1;
    const double a = std::clamp((phi - ring(i)) / (ring(i + 1) - ring(i)), 0.0, 1.0);
    const double b = std::min(column - static_cast<double>(j), 1.0);
    const std::size_t above = i * columns();
    const std::size_t below = above + columns();
    return {{above + j, above + right, below + j, below + right},
            {(1.0 - a) * (1.0 - b), (1.0 - a) * b, a * (1.0 - b), a * b},
            4,
            above + j};
  }

  // Cells lie between parallels and meridians.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return latitude_is_monotone(a, b); }

  // Half the diagonal of a cell at the rim, and the whole diagonal. Rings are farthest apart there, and
  // columns nowhere farther than p.
  double covering_radius() const { return 0.5 * stencil_radius(); }
  double stencil_radius() const {
    return std::hypot(ring(n_) - ring(n_ - 1), 0.5 * kPi / static_cast<double>(n_));
  }

  friend bool operator==(const WeightedRings&, const WeightedRings&) = default;

 private:
  explicit WeightedRings(std::size_t n) : n_(n) {}

  double upper(std::size_t i) const {
    return 2.0 * std::asin(static_cast<double>(i) * std::sin(0.25 * kPi) / static_cast<double>(n_));
  }

  std::size_t n_ = 90;  // segments of the meridian from the apex to the rim
};

static_assert(SamplingScheme<WeightedRings>);

}  // namespace impinge::lab
