// SPDX-License-Identifier: GPL-3.0-or-later
// The equal-area octahedral map: each quarter of the sphere 90 q <= theta <= 90 (q + 1) degrees is a square
// of n by n cells of equal area.
//
// Node (i, j) of a square is at
//   north, i + j <= n:  r = (i + j) / n,      z = 1 - r^2,  theta = 90 (q + j / (i + j)) degrees
//   south, i + j >= n:  r = 2 - (i + j) / n,  z = r^2 - 1,  theta = 90 (q + (n - i) / (2 n - i - j)) degrees
// The equator is the diagonal i + j = n. So ring s = i + j has 4 s entries in the north and 4 (2 n - s) in
// the south, equally spaced: 4 n^2 + 2 entries, numbered ring by ring. A look-up is bilinear in (i, j), with
// one arctangent.
//
// Precision is 90 / n degrees: 4 n entries stand on the equator.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <Eigen/Geometry>

#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/ring_walker.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class OctahedralEqualArea {
 public:
  static constexpr std::string_view name = "octahedral_equal_area";
  static constexpr std::string_view label = "Octahedral, equal-area";
  static constexpr std::string_view citation = "Clarberg 2008, Journal of Graphics Tools 13(3):53-68";

  OctahedralEqualArea() : OctahedralEqualArea(90) {}
  static OctahedralEqualArea with_precision(double degrees) {
    return OctahedralEqualArea(equator_division(degrees, 90.0, label));
  }

  std::size_t divisions() const { return n_; }  // n
  std::size_t size() const { return 4 * n_ * n_ + 2; }
  std::size_t cells() const { return 4 * n_ * n_; }
  std::size_t equator_points() const { return 4 * n_; }
  double precision_deg() const { return 90.0 / static_cast<double>(n_); }
  double covering_radius() const { return covering_radius_; }

  /// With du, dv <= 1 / n along a straight way in the square, dr <= 2 / n and, q = 2 - r^2 in [1, 2],
  ///   ds^2 = (2 / sqrt(q) dr)^2 + (pi / 2 sqrt(q) max(du, dv))^2 <= (16 / q + pi^2 q / 4) / n^2,
  /// at most 16 + pi^2 / 4, on the equator.
  double stencil_radius() const {
    return std::min(std::sqrt(16.0 + kPi * kPi / 4.0) / static_cast<double>(n_), kPi);
  }

  Vec3 direction(std::size_t entry) const {
    const Ring on = ring(ring_of(entry));
    return on.direction(entry - on.first);
  }

  Stencil stencil(const Vec3& x) const;

  /// In an octant, which great circles bound, cells lie between lines of whole u = n r (1 - q) and v = n r q
  /// with q = 2 theta / pi and r = sqrt(2) sin(phi / 2), phi from the nearer pole. r' <= 1 / sqrt(2), and
  /// with the bounds of ArcAngles
  ///   |r''| <= |cot phi| / sqrt(2) + 1 / 4,   |(r q)''| <= |r''| + 2 |r' q'| + r |q''|,   r <= sin(phi)
  /// since r'' = (cos(phi / 2) phi'' - sin(phi / 2) phi'^2 / 2) / sqrt(2); and likewise for 1 - q.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const {
    if (quarter_of(a) != quarter_of(b) || (a.z() >= 0.0) != (b.z() >= 0.0)) return false;
    const ArcAngles arc(a, b);
    if (arc.sine == 0.0) return false;
    const double bend_of_r = std::sqrt(0.5) * arc.cotangent() + 0.25;
    const double bend = bend_of_r + 2.0 / kPi * (std::numbers::sqrt2 / arc.sine + arc.cotangent());
    const double most = static_cast<double>(n_) * bend * arc.length * arc.length;
    const SquarePlace from = square_place(a);
    const SquarePlace to = square_place(b);
    return passes_lines_once(from.u, to.u, most) && passes_lines_once(from.v, to.v, most);
  }

  /// A quarter of each cell round the entry: of four cells, or of two at the four corners of the equator.
  double area(std::size_t entry) const {
    const std::size_t first = ring(n_).first;
    const bool corner = entry >= first && entry < first + 4 * n_ && (entry - first) % n_ == 0;
    const auto n = static_cast<double>(n_);
    return (corner ? 0.5 : 1.0) * kPi / (n * n);
  }

  RingWalker<OctahedralEqualArea> walker() const { return RingWalker(*this); }

  /// Ring 0 is the north pole, ring n the equator, ring 2 n the south pole.
  std::size_t rings() const { return 2 * n_ + 1; }
  Ring ring(std::size_t k) const;
  double ring_position(double phi) const {
    const auto n = static_cast<double>(n_);
    if (phi <= 0.5 * kPi) return std::numbers::sqrt2 * n * std::sin(0.5 * phi);
    return 2.0 * n - std::numbers::sqrt2 * n * std::sin(0.5 * (kPi - phi));
  }

  friend bool operator==(const OctahedralEqualArea&, const OctahedralEqualArea&) = default;

 private:
  explicit OctahedralEqualArea(std::size_t n) : n_(n), covering_radius_(find_covering_radius()) {}

  static std::size_t quarter_of(const Vec3& x) {
    if (x.x() > 0.0 && x.y() >= 0.0) return 0;
    if (x.y() > 0.0) return 1;
    if (x.x() < 0.0) return 2;
    return x.y() < 0.0 ? 3 : 0;
  }

  /// Ring of an entry counted from its pole: the first s rings hold 1 + 2 s (s - 1) entries before ring s.
  static std::size_t ring_from_pole(std::size_t entry) {
    if (entry == 0) return 0;
    auto s = static_cast<std::size_t>(0.5 * (1.0 + std::sqrt(2.0 * static_cast<double>(entry) - 1.0)));
    while (1 + 2 * s * (s - 1) > entry) --s;
    while (1 + 2 * s * (s + 1) <= entry) ++s;
    return s;
  }
  std::size_t ring_of(std::size_t entry) const {
    if (entry <= 2 * n_ * (n_ + 1)) return ring_from_pole(entry);
    return 2 * n_ - ring_from_pole(size() - 1 - entry);
  }

  /// Entry at node (i, j) of a quarter.
  std::size_t entry_at(std::size_t quarter, std::size_t i, std::size_t j) const {
    const std::size_t k = i + j;
    if (k == 0) return 0;
    if (k == 2 * n_) return size() - 1;
    const std::size_t step = k <= n_ ? quarter * k + j : quarter * (2 * n_ - k) + n_ - i;
    const Ring on = ring(k);
    return on.first + step % on.count;
  }

  /// Where a direction is in the square of its quarter, in cells.
  struct SquarePlace {
    double u;
    double v;
  };
  SquarePlace square_place(const Vec3& x) const;

  double find_covering_radius() const;

  /// With more rings the covering radius is taken from its limit for fine grids, larger by less than 1 %.
  static constexpr std::size_t kMostRings = 4096;

  std::size_t n_;
  double covering_radius_;  // radians
};

inline Ring OctahedralEqualArea::ring(std::size_t k) const {
  const bool north = k <= n_;
  const std::size_t s = north ? k : 2 * n_ - k;
  const double r = static_cast<double>(s) / static_cast<double>(n_);
  const double z = 1.0 - r * r;
  const CosSin polar{north ? z : -z, r * std::sqrt(2.0 - r * r)};
  if (s == 0) return {{north ? 0 : size() - 1, 1, 0}, polar};
  return {{north ? 1 + 2 * s * (s - 1) : size() - 1 - 2 * s * (s + 1), 4 * s, 0}, polar};
}

/// The widest gaps are those between two rings beside theta = 0, where four entries nearly make a rectangle.
inline double OctahedralEqualArea::find_covering_radius() const {
  if (n_ > kMostRings) return 0.5 * std::sqrt(2.0 + kPi * kPi / 2.0) / static_cast<double>(n_);
  double widest = 0.0;
  for (std::size_t k = 0; k < n_; ++k) {
    const Ring upper = ring(k);
    const Ring lower = ring(k + 1);
    const Vec3 a = upper.direction(0);
    const Vec3 b = upper.direction(1 % upper.count);
    const Vec3 c = lower.direction(0);
    const Vec3 d = lower.direction(1);
    widest = std::max(widest, std::min(std::max(circumradius(a, b, c), circumradius(b, c, d)),
                                       std::max(circumradius(a, b, d), circumradius(a, c, d))));
  }
  return widest;
}

inline OctahedralEqualArea::SquarePlace OctahedralEqualArea::square_place(const Vec3& x) const {
  // (along, across) is (x, y) turned back by 90 degrees for each quarter.
  const std::size_t quarter = quarter_of(x);
  const double along = quarter % 2 == 0 ? std::abs(x.x()) : std::abs(x.y());
  const double across = quarter % 2 == 0 ? std::abs(x.y()) : std::abs(x.x());
  const double share = across == 0.0 ? 0.0 : std::atan2(across, along) * (2.0 / kPi);
  // r^2 = 1 - |z|, without cancellation near the poles.
  const Vec3 unit = x.stableNormalized();
  const double r = std::min(std::hypot(unit.x(), unit.y()) / std::sqrt(1.0 + std::abs(unit.z())), 1.0);
  const auto n = static_cast<double>(n_);
  if (x.z() >= 0.0) return {n * (r * (1.0 - share)), n * (r * share)};
  return {n - n * (r * share), n - n * (r * (1.0 - share))};
}

inline Stencil OctahedralEqualArea::stencil(const Vec3& x) const {
  const std::size_t quarter = quarter_of(x);
  const auto [u, v] = square_place(x);
  const std::size_t i = std::min(static_cast<std::size_t>(u), n_ - 1);
  const std::size_t j = std::min(static_cast<std::size_t>(v), n_ - 1);
  const double a = std::min(u - static_cast<double>(i), 1.0);
  const double b = std::min(v - static_cast<double>(j), 1.0);
  return {{entry_at(quarter, i, j), entry_at(quarter, i + 1, j), entry_at(quarter, i, j + 1),
           entry_at(quarter, i + 1, j + 1)},
          {(1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b},
          4,
          (quarter * n_ + j) * n_ + i};
}

static_assert(AreaScheme<OctahedralEqualArea>);

}  // namespace impinge
