// SPDX-License-Identifier: GPL-3.0-or-later
// Fibonacci lattice: entry i of N at z = 1 - 2 (i + eps) / (N - 1 + 2 eps) and theta = 2 pi i / golden ratio.
//
// eps = 1/4 leaves the smallest gap at the poles, N rho^2 = 6.74; the usual 1/2 leaves 7.44, and 0.36, which
// keeps entries farthest apart, 7.04. In turns of theta and entries of z this is a plane lattice. At each
// latitude its shortest steps are two consecutive Fibonacci numbers a, b, so that the entries round a
// direction are i + m a + n b in closed form (Keinert et al. 2015). The interpolation is linear in the
// Delaunay triangle of entries that holds the direction, at the poles too.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "sphere/angular_box.hpp"
#include "sphere/direction.hpp"
#include "sphere/holding_triangle.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class Fibonacci {
 public:
  static constexpr std::string_view name = "fibonacci";
  static constexpr std::string_view label = "Fibonacci lattice";
  static constexpr std::string_view citation =
      "Gonzalez 2010, doi:10.1007/s11004-009-9257-x; Keinert, Innmann, Saenger & Stamminger 2015, "
      "doi:10.1145/2816795.2818131";
  static constexpr bool kFlatCells = true;  // spherical Delaunay triangles

  Fibonacci() : Fibonacci(41253) {}
  static Fibonacci with_precision(double degrees);

  std::size_t size() const { return size_; }
  /// Eight numbers for each entry; no triangle has some of them, see cell_of().
  std::size_t cells() const { return 8 * size_; }
  /// How many entries a row round the equator would have if entries stood in squares.
  std::size_t equator_points() const {
    return static_cast<std::size_t>(std::round(std::sqrt(kPi * count())));
  }
  double precision_deg() const { return std::sqrt(4.0 * kPi / count()) / kDegree; }

  Vec3 direction(std::size_t entry) const {
    const auto i = static_cast<double>(entry);
    const double rest = count() - 1.0 - i;
    const double sin_phi = 2.0 * std::sqrt((i + kEps) * (rest + kEps)) / height();
    const double theta = kTurn * static_cast<double>(static_cast<std::int64_t>(azimuth(entry)));
    return {sin_phi * std::cos(theta), sin_phi * std::sin(theta), (rest - i) / height()};
  }

  Stencil stencil(const Vec3& x) const;

  /// The gap at the pole, N rho^2 = 6.74; away from the poles N rho^2 = 2 pi, where the lattice is square.
  double covering_radius() const { return covering_radius_; }
  /// A Delaunay triangle lies in a circle of the covering radius.
  double stencil_radius() const { return 2.0 * covering_radius_; }

  /// The zone half a step of z either way; towards the pole the first and the last entry have eps steps
  /// instead.
  double area(std::size_t entry) const {
    const bool end = entry == 0 || entry + 1 == size_;
    return (end ? 0.5 + kEps : 1.0) * 4.0 * kPi / height();
  }

  const Fibonacci& walker() const { return *this; }
  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const;

  friend bool operator==(const Fibonacci& a, const Fibonacci& b) { return a.size_ == b.size_; }

 private:
  /// Azimuths are counted in 2^-64 turns, in which arithmetic modulo a turn is exact.
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio
  static constexpr double kTurn = 2.0 * kPi * 0x1p-64;           // radians in one
  static constexpr double kGoldenRatio = 1.6180339887498948482;
  static constexpr double kEps = 0.25;
  static constexpr std::size_t kPolarZone = 12;     // entries from the pole, where
  static constexpr std::size_t kPolarEntries = 40;  // so many polar entries are tried
  static constexpr double kMostEntries = 5e10;

  explicit Fibonacci(std::size_t size) : size_(size), covering_radius_(find_covering_radius()) {}

  double count() const { return static_cast<double>(size_); }
  double height() const { return count() - 1.0 + 2.0 * kEps; }  // of the sphere, in entries
  static std::uint64_t azimuth(std::size_t entry) { return kGolden * entry; }
  static std::uint64_t azimuth_of(double theta) {
    const double turns = theta / (2.0 * kPi);
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>((turns - std::round(turns)) * 0x1.fffffffffffffp63));
  }

  double find_covering_radius() const;
  std::size_t entries_round(const Vec3& u, std::array<std::size_t, kPolarEntries>& entries) const;
  std::size_t cell_of(std::array<std::size_t, 3> entry) const;

  std::size_t size_;
  double covering_radius_;
};

/// The gap at the pole. Beyond the first 64 entries of each pole the lattice is nearly flat, and its gap, N
/// rho^2 = 2 pi, is smaller.
inline double Fibonacci::find_covering_radius() const {
  const double reach = 4.2 / std::sqrt(count());
  std::vector<Vec3> polar;
  for (std::size_t i = 0; i < std::min<std::size_t>(size_, 160); ++i) polar.push_back(direction(i));
  const double z_min = std::max(1.0 - 128.0 / count(), -0.2);
  return largest_gap(polar, z_min, reach) * (1.0 + 1e-9);
}

/// All entries within two covering radii of u, and some more; returns their number.
inline std::size_t Fibonacci::entries_round(const Vec3& u,
                                            std::array<std::size_t, kPolarEntries>& entries) const {
  const double place = std::clamp(0.5 * height() * (1.0 - u.z()) - kEps, 0.0, count() - 1.0);
  const double from_pole = std::min(place, count() - 1.0 - place);
  std::size_t found = 0;
  if (from_pole < static_cast<double>(kPolarZone)) {
    found = std::min(size_, kPolarEntries);
    const std::size_t first = u.z() > 0.0 ? 0 : size_ - found;
    for (std::size_t k = 0; k < found; ++k) entries[k] = first + k;
    return found;
  }
  // With G the golden ratio, steps a = F(k) and b = F(k + 1) are equally long, and the lattice is square,
  // where 2 pi sin(phi) / G^(k + 1/2) = 2 G^(k + 1/2) / (sqrt(5) N sin(phi)).
  const double square =
      std::log(std::sqrt(5.0) * kPi * count() * (1.0 - u.z() * u.z())) / std::log(kGoldenRatio);
  std::int64_t a = 1;
  std::int64_t b = 1;
  for (double k = 1.0; k < std::round(0.5 * square - 0.5); k += 1.0) b = std::exchange(a, b) + b;
  const auto near = static_cast<std::int64_t>(std::round(place));
  const auto turns_of = [](std::uint64_t angle) {
    return static_cast<double>(static_cast<std::int64_t>(angle)) * 0x1p-64;
  };
  const double across = turns_of(azimuth_of(to_angles(u).theta) - azimuth(static_cast<std::size_t>(near)));
  const double along = place - static_cast<double>(near);
  const double turns_a = turns_of(azimuth(static_cast<std::size_t>(a)));
  const double turns_b = turns_of(azimuth(static_cast<std::size_t>(b)));
  const double area = turns_a * static_cast<double>(b) - turns_b * static_cast<double>(a);  // 1 or -1
  const auto m =
      static_cast<std::int64_t>(std::floor((across * static_cast<double>(b) - turns_b * along) / area));
  const auto n =
      static_cast<std::int64_t>(std::floor((turns_a * along - across * static_cast<double>(a)) / area));
  for (std::int64_t i = m - 1; i <= m + 2; ++i) {
    for (std::int64_t j = n - 1; j <= n + 2; ++j) {
      const std::int64_t entry = near + i * a + j * b;
      if (entry >= 0 && entry < static_cast<std::int64_t>(size_))
        entries[found++] = static_cast<std::size_t>(entry);
    }
  }
  return found;
}

inline Stencil Fibonacci::stencil(const Vec3& x) const {
  const Vec3 u = x.normalized();
  std::array<std::size_t, kPolarEntries> entries{};
  const std::size_t found = entries_round(u, entries);
  std::array<Vec3, kPolarEntries> directions;
  for (std::size_t k = 0; k < found; ++k) directions[k] = direction(entries[k]);
  const HoldingTriangle triangle = holding_triangle({directions.data(), found}, u);
  std::array<std::size_t, 3> corner{};
  for (std::size_t k = 0; k < 3; ++k) corner[k] = entries[triangle.place[k]];
  return {{corner[0], corner[1], corner[2], 0},
          {triangle.weight[0], triangle.weight[1], triangle.weight[2], 0.0},
          3,
          cell_of(corner)};
}

/// Entry i begins the triangles (i, i + F(k), i + F(k + 2)) and (i, i + F(k + 1), i + F(k + 2)), for one k
/// or, where the shortest steps change, for two or three. k modulo 4, and which of the two it is, tell its
/// triangles apart.
inline std::size_t Fibonacci::cell_of(std::array<std::size_t, 3> entry) const {
  std::sort(entry.begin(), entry.end());
  const std::size_t far = entry[2] - entry[0];
  std::size_t order = 0;
  std::size_t a = 1;
  for (std::size_t b = 2; a < far; ++order) b += std::exchange(a, b);
  const std::size_t half = 2 * (entry[1] - entry[0]) > far ? 1 : 0;
  return 8 * entry[0] + 2 * (order % 4) + half;
}

/// From an entry whose azimuth is in an interval, the next such entry is one of three Fibonacci numbers of
/// entries away (three gap theorem), so that after the first one no entry outside is looked at.
template <class Visit>
void Fibonacci::visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
  constexpr double kSlack = 1e-6;
  const AngularBox box = angular_box(cone.corners(), margin);
  const auto place = [&](double phi) {
    const double half = std::sin(0.5 * phi);
    return height() * half * half - kEps;
  };
  const double last = std::min(place(box.phi_max) + kSlack, count() - 1.0);
  auto entry = static_cast<std::size_t>(std::ceil(std::max(place(box.phi_min) - kSlack, 0.0)));
  const double turns = box.theta_width / (2.0 * kPi) + 1e-11;
  const bool all = turns > 0.6;
  const std::uint64_t width = all ? ~std::uint64_t{0} : static_cast<std::uint64_t>(turns * 0x1p64);
  const std::uint64_t from = azimuth_of(box.theta_min - 1e-11);
  const auto is_inside = [&](std::size_t i) { return azimuth(i) - from <= width; };
  std::array<std::size_t, 3> steps{1, 2, 3};
  // The smallest Fibonacci number whose step in azimuth is within the interval, and the next two.
  const auto shift = [](std::size_t step) { return std::min(azimuth(step), ~azimuth(step) + 1); };
  while (!all && shift(steps[0]) >= width) steps = {steps[1], steps[2], steps[1] + steps[2]};
  while (static_cast<double>(entry) <= last) {
    if (!is_inside(entry)) {
      ++entry;
      continue;
    }
    visit_in_runs(
        entry, 1, [&](std::size_t) { return direction(entry); }, visit);
    const auto* step =
        std::find_if(steps.begin(), steps.end(), [&](std::size_t s) { return is_inside(entry + s); });
    entry += step == steps.end() ? 1 : *step;
  }
}

inline Fibonacci Fibonacci::with_precision(double degrees) {
  if (!(degrees > 0.0 && degrees <= 60.0)) {
    throw std::invalid_argument("a Fibonacci lattice has a precision above 0 and at most 60 degrees");
  }
  const double spacing = degrees * kDegree;
  const double size = std::round(4.0 * kPi / spacing / spacing);
  if (!(size <= kMostEntries)) {
    throw std::invalid_argument("a Fibonacci lattice has a precision of at least 0.001 degrees");
  }
  return Fibonacci(static_cast<std::size_t>(size));
}

static_assert(AreaScheme<Fibonacci>);

}  // namespace impinge
