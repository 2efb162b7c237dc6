// SPDX-License-Identifier: GPL-3.0-or-later
// HEALPix: entries at the centres of 12 nside^2 pixels of equal area, in the RING order; nside is any whole
// number.
//
// Ring i = 1 .. 4 nside - 1. Polar cap, i < nside: 4 i entries at z = 1 - i^2 / (3 nside^2), theta = (t +
// 1/2) 90 / i degrees; the south mirrors it. Between, 4 nside entries at z = 4/3 - 2 i / (3 nside), theta =
// (t + h) 90 / nside, h = 1/2 if i - nside is even, else 0. Lookup is as in the HEALPix software
// (get_interpol): linear along the two rings next to the query, then linear in the polar angle; within the
// first ring the mean of its 4 entries stands for the pole.
//
// Precision is 90 / nside degrees: 4 nside entries stand on the equator.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "sphere/direction.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/ring_interpolation.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class Healpix : public RingInterpolation<Healpix> {
 public:
  static constexpr std::string_view name = "healpix";
  static constexpr std::string_view label = "HEALPix";
  static constexpr std::string_view citation = "Gorski et al. 2005, Astrophysical Journal 622:759-771";

  Healpix() : Healpix(90) {}
  static Healpix with_precision(double degrees) { return Healpix(equator_division(degrees, 90.0, label)); }

  std::size_t nside() const { return n_; }  // pixels along an edge of each of the 12 base pixels
  std::size_t size() const { return 12 * n_ * n_; }
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
    if (place < 0.0) return cap_stencil(0, phi / polar_angle(0), theta);
    if (place > static_cast<double>(last)) return cap_stencil(last, (kPi - phi) / polar_angle(0), theta);
    const std::size_t k = std::min(static_cast<std::size_t>(place), last - 1);
    const double upper = polar_angle(k);
    const double down = std::clamp((phi - upper) / (polar_angle(k + 1) - upper), 0.0, 1.0);
    return between(k, theta, down);
  }

  double area(std::size_t) const { return 4.0 * kPi / static_cast<double>(size()); }

  /// Ring k of the library is ring i = k + 1 of the paper.
  std::size_t rings() const { return 4 * n_ - 1; }
  Ring ring(std::size_t k) const;
  RingRow row(std::size_t k) const { return ring(k); }
  double ring_position(double phi) const;
  double polar_angle(std::size_t k) const {
    const CosSin polar = ring(k).polar;
    return std::atan2(polar.sin, polar.cos);
  }
  std::size_t ring_of(std::size_t entry) const {
    const std::size_t cap = 2 * n_ * (n_ - 1);
    if (entry < cap) return ring_from_pole(entry) - 1;
    if (entry >= size() - cap) return 4 * n_ - ring_from_pole(size() - 1 - entry) - 1;
    return n_ + (entry - cap) / (4 * n_) - 1;
  }

  friend bool operator==(const Healpix&, const Healpix&) = default;

 private:
  explicit Healpix(std::size_t n) : n_(n), stencil_radius_(find_stencil_radius()) {}

  /// Ring of an entry of a cap, counted from 1 at its pole: 2 i (i - 1) entries come before ring i.
  static std::size_t ring_from_pole(std::size_t entry) {
    auto i = static_cast<std::size_t>(0.5 * (1.0 + std::sqrt(1.0 + 2.0 * static_cast<double>(entry))));
    while (2 * i * (i - 1) > entry) --i;
    while (2 * i * (i + 1) <= entry) ++i;
    return i;
  }
  double find_stencil_radius() const;

  std::size_t n_;
  double stencil_radius_;  // radians
};

inline Ring Healpix::ring(std::size_t k) const {
  const auto n = static_cast<double>(n_);
  const std::size_t i = k + 1;
  if (i >= n_ && i <= 3 * n_) {
    const double z = (4.0 * n - 2.0 * static_cast<double>(i)) / (3.0 * n);
    return {{2 * n_ * (n_ - 1) + (i - n_) * 4 * n_, 4 * n_, (i - n_ + 1) % 2},
            {z, std::sqrt((1.0 - z) * (1.0 + z))}};
  }
  const bool north = i < n_;
  const std::size_t s = north ? i : 4 * n_ - i;
  const double height = static_cast<double>(s) / n * (static_cast<double>(s) / n) / 3.0;  // 1 - |z|
  const double z = 1.0 - height;
  return {{north ? 2 * s * (s - 1) : size() - 2 * s * (s + 1), 4 * s, 1},
          {north ? z : -z, std::sqrt(height * (2.0 - height))}};
}

inline double Healpix::ring_position(double phi) const {
  const auto n = static_cast<double>(n_);
  const double z = std::cos(phi);
  if (z > 2.0 / 3.0) return std::sqrt(6.0) * n * std::sin(0.5 * phi) - 1.0;
  if (z < -2.0 / 3.0) return 4.0 * n - std::sqrt(6.0) * n * std::sin(0.5 * (kPi - phi)) - 1.0;
  return n * (2.0 - 1.5 * z) - 1.0;
}

/// The way to a tap is longest next to the poles, at the equator, or across a cap.
inline double Healpix::find_stencil_radius() const {
  double largest = 2.0 * polar_angle(0);
  constexpr std::size_t few = 32;
  const std::size_t pairs = 2 * n_ - 1;  // from the north pole to the equator
  for (std::size_t k = 0; k < std::min(few, pairs); ++k) largest = std::max(largest, way_across(k));
  for (std::size_t k = pairs - std::min(few, pairs); k < pairs; ++k)
    largest = std::max(largest, way_across(k));
  return largest;
}

static_assert(AreaScheme<Healpix>);

}  // namespace impinge
