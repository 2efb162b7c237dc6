// SPDX-License-Identifier: GPL-3.0-or-later
// HEALPix: the sphere in 12 nside^2 pixels of equal area, entries at their centres, in the RING order; nside
// is any whole number.
//
// Ring i = 1 .. 4 nside - 1. Polar cap, i < nside: 4 i entries at z = 1 - i^2 / (3 nside^2), theta = (t +
// 1/2) 90 / i degrees; the south mirrors it. Between, 4 nside entries at z = 4/3 - 2 i / (3 nside), theta =
// (t + h) 90 / nside, h = 1/2 if i - nside is even, else 0. Lookup is that of the HEALPix software
// (get_interpol): linear along the two rings next to the query, then linear in the polar angle; within the
// first ring the mean of its 4 entries stands for the pole.
//
// Precision is 90 / nside degrees: 4 nside entries stand on the equator.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/ring_walker.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class Healpix {
 public:
  static constexpr std::string_view name = "healpix";
  static constexpr std::string_view label = "HEALPix";
  static constexpr std::string_view citation = "Gorski et al. 2005, Astrophysical Journal 622:759-771";

  Healpix() : Healpix(90) {}
  static Healpix with_precision(double degrees) { return Healpix(equator_division(degrees, 90.0, label)); }

  std::size_t nside() const { return n_; }  // pixels along an edge of each of the 12 base pixels
  std::size_t size() const { return 12 * n_ * n_; }
  /// One for each cap, and for two rings as many as they have entries.
  std::size_t cells() const { return 2 * size() - 6; }
  std::size_t equator_points() const { return 4 * n_; }
  double precision_deg() const { return 90.0 / static_cast<double>(n_); }

  /// The poles are farthest from all entries, in the middle of the first ring: 1 - cos = 1 / (3 nside^2).
  double covering_radius() const { return 2.0 * std::asin(1.0 / (std::sqrt(6.0) * static_cast<double>(n_))); }
  double stencil_radius() const { return stencil_radius_; }

  Vec3 direction(std::size_t entry) const {
    const Ring on = ring(ring_of(entry));
    return on.direction(entry - on.first);
  }

  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const double place = ring_position(phi);
    const std::size_t last = rings() - 1;
    if (place < 0.0) return cap_stencil(0, phi / polar_angle(0), theta, 0);
    if (place > static_cast<double>(last)) {
      return cap_stencil(last, (kPi - phi) / polar_angle(0), theta, cells() - 1);
    }
    const std::size_t k = std::min(static_cast<std::size_t>(place), last - 1);
    const double upper = polar_angle(k);
    const double down = std::clamp((phi - upper) / (polar_angle(k + 1) - upper), 0.0, 1.0);
    return between(k, theta, down);
  }

  /// Entries of one ring do not stand below those of the next, so that a cell reads entries beyond its
  /// corners: from any direction there is a way to each tap, no longer than stencil_radius(), through the
  /// cells that have the same gap above or the same gap below. Calls visit(stencil) for all of these; the
  /// weights are of no meaning.
  template <class Visit>
  void for_each_cell_across(const Stencil& at, Visit&& visit) const {
    if (at.cell == 0 || at.cell == cells() - 1) return;
    const std::size_t k = ring_of(at.entry[0]);
    const auto visit_middle = [&](double theta) { visit(between(k, theta, 0.0)); };
    for_each_overlap(ring(k), at.entry[0], ring(k + 1), visit_middle);
    for_each_overlap(ring(k + 1), at.entry[2], ring(k), visit_middle);
  }

  /// Cells lie between parallels and meridians.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return latitude_is_monotone(a, b); }

  double area(std::size_t) const { return 4.0 * kPi / static_cast<double>(size()); }

  RingWalker<Healpix> walker() const { return RingWalker(*this); }

  /// Ring k of the library is ring i = k + 1 of the paper.
  std::size_t rings() const { return 4 * n_ - 1; }
  Ring ring(std::size_t k) const;
  double ring_position(double phi) const;

  friend bool operator==(const Healpix&, const Healpix&) = default;

 private:
  /// The gap of a ring that holds an azimuth: the entries left and right of it, the number of gaps begun
  /// since theta = 0, and the share of the gap that is left of it.
  struct Gap {
    std::size_t left;
    std::size_t right;
    std::size_t step;
    double share;
  };

  explicit Healpix(std::size_t n) : n_(n), stencil_radius_(find_stencil_radius()) {}

  double polar_angle(std::size_t k) const {
    const CosSin polar = ring(k).polar;
    return std::atan2(polar.sin, polar.cos);
  }

  /// Ring of an entry of a cap, counted from 1 at its pole: 2 i (i - 1) entries come before ring i.
  static std::size_t ring_from_pole(std::size_t entry) {
    auto i = static_cast<std::size_t>(0.5 * (1.0 + std::sqrt(1.0 + 2.0 * static_cast<double>(entry))));
    while (2 * i * (i - 1) > entry) --i;
    while (2 * i * (i + 1) <= entry) ++i;
    return i;
  }
  std::size_t ring_of(std::size_t entry) const {
    const std::size_t cap = 2 * n_ * (n_ - 1);
    if (entry < cap) return ring_from_pole(entry) - 1;
    if (entry >= size() - cap) return 4 * n_ - ring_from_pole(size() - 1 - entry) - 1;
    return n_ + (entry - cap) / (4 * n_) - 1;
  }

  static Gap gap(const Ring& ring, double theta) {
    const double place = ring.position(theta);
    const double left = std::min(std::floor(place), static_cast<double>(ring.count) - 1.0);
    const std::size_t step = static_cast<std::size_t>(left + static_cast<double>(ring.half));
    const std::size_t entry = (step + ring.count - ring.half) % ring.count;
    return {entry, (entry + 1) % ring.count, step, std::min(place - left, 1.0)};
  }

  Stencil between(std::size_t k, double theta, double down) const;
  Stencil cap_stencil(std::size_t k, double outwards, double theta, std::size_t cell) const;
  template <class Visit>
  static void for_each_overlap(const Ring& ring, std::size_t entry, const Ring& other, Visit&& visit);
  double find_stencil_radius() const;

  std::size_t n_;
  double stencil_radius_;  // radians
};

inline Ring Healpix::ring(std::size_t k) const {
  const auto n = static_cast<double>(n_);
  const std::size_t i = k + 1;
  if (i >= n_ && i <= 3 * n_) {
    const double z = (4.0 * n - 2.0 * static_cast<double>(i)) / (3.0 * n);
    return {2 * n_ * (n_ - 1) + (i - n_) * 4 * n_,
            4 * n_,
            (i - n_ + 1) % 2,
            {z, std::sqrt((1.0 - z) * (1.0 + z))}};
  }
  const bool north = i < n_;
  const std::size_t s = north ? i : 4 * n_ - i;
  const double height = static_cast<double>(s) / n * (static_cast<double>(s) / n) / 3.0;  // 1 - |z|
  const double z = 1.0 - height;
  return {north ? 2 * s * (s - 1) : size() - 2 * s * (s + 1),
          4 * s,
          1,
          {north ? z : -z, std::sqrt(height * (2.0 - height))}};
}

inline double Healpix::ring_position(double phi) const {
  const auto n = static_cast<double>(n_);
  const double z = std::cos(phi);
  if (z > 2.0 / 3.0) return std::sqrt(6.0) * n * std::sin(0.5 * phi) - 1.0;
  if (z < -2.0 / 3.0) return 4.0 * n - std::sqrt(6.0) * n * std::sin(0.5 * (kPi - phi)) - 1.0;
  return n * (2.0 - 1.5 * z) - 1.0;
}

inline Stencil Healpix::between(std::size_t k, double theta, double down) const {
  const Ring upper = ring(k);
  const Ring lower = ring(k + 1);
  const Gap a = gap(upper, theta);
  const Gap b = gap(lower, theta);
  // Where both gaps cross theta = 0 the cell does, too: its last number is its first.
  const std::size_t step = (a.step + b.step) % (upper.count + lower.count);
  return {{upper.first + a.left, upper.first + a.right, lower.first + b.left, lower.first + b.right},
          {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down * (1.0 - b.share), down * b.share},
          4,
          upper.first + lower.first - 3 + step};
}

/// `outwards` from 0 at the pole to 1 on the ring.
inline Stencil Healpix::cap_stencil(std::size_t k, double outwards, double theta, std::size_t cell) const {
  const Ring on = ring(k);
  const Gap at = gap(on, theta);
  const double w = std::clamp(outwards, 0.0, 1.0);
  Stencil stencil{{on.first, on.first + 1, on.first + 2, on.first + 3}, {}, 4, cell};
  stencil.weight.fill(0.25 * (1.0 - w));
  stencil.weight[at.left] += w * (1.0 - at.share);
  stencil.weight[at.right] += w * at.share;
  return stencil;
}

/// Calls visit(theta) with the middle of each stretch that the gap right of an entry shares with one of the
/// other ring.
template <class Visit>
void Healpix::for_each_overlap(const Ring& ring, std::size_t entry, const Ring& other, Visit&& visit) {
  const double step = 2.0 * kPi / static_cast<double>(ring.count);
  const double other_step = 2.0 * kPi / static_cast<double>(other.count);
  const double from = (static_cast<double>(entry - ring.first) + 0.5 * static_cast<double>(ring.half)) * step;
  const double to = from + step;
  const double half = 0.5 * static_cast<double>(other.half);
  for (double left = std::floor(other.position(from)); (left + half) * other_step < to; left += 1.0) {
    const double begin = std::max(from, (left + half) * other_step);
    const double end = std::min(to, (left + 1.0 + half) * other_step);
    if (end - begin < 1e-6 * other_step) continue;  // they only touch
    visit(std::fmod(0.5 * (begin + end), 2.0 * kPi));
  }
}

/// From an entry to the far end of a gap of the next ring, without leaving the rings between: along the ring
/// nearer to the pole as far as the pole is in the way, and then straight. Longest next to the poles or at
/// the equator; or across a cap.
inline double Healpix::find_stencil_radius() const {
  double largest = 2.0 * polar_angle(0);
  const auto consider = [&](std::size_t k) {
    const double gap = 2.0 * kPi / static_cast<double>(ring(k).count);
    const double upper = polar_angle(k);
    const double lower = polar_angle(k + 1);
    const double seen = k + 2 < 2 * n_ ? std::acos(std::tan(upper) / std::tan(lower)) : 0.5 * kPi;
    const double straight = std::min(gap, seen);
    largest = std::max(largest, std::sin(upper) * (gap - straight) + separation(upper, lower, straight));
  };
  constexpr std::size_t few = 32;
  const std::size_t pairs = 2 * n_ - 1;  // from the north pole to the equator
  for (std::size_t k = 0; k < std::min(few, pairs); ++k) consider(k);
  for (std::size_t k = pairs - std::min(few, pairs); k < pairs; ++k) consider(k);
  return largest;
}

static_assert(AreaScheme<Healpix>);

}  // namespace impinge
