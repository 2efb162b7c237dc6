// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of schemes with rings of equal latitude that interpolate linearly in theta along two rings and then
// linearly in phi. A patch lies between entries of the two rings; s = theta, t = phi.
//
// On the unit sphere du/dphi has length 1 and no acceleration; du/dtheta has length sin(phi) and the
// acceleration sin(phi) |cos(phi)|.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "sphere/direction.hpp"
#include "sphere/schemes/healpix.hpp"
#include "sphere/schemes/latitude_rows.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/patches/patch.hpp"

namespace impinge {

/// A ring at polar angle phi (radians) with entries at 2 pi (k + shift) / count.
struct AngleRing {
  double phi;         // polar angle
  std::size_t count;  // of entries
  double shift;       // of the first entry, in steps
};

/// Largest sin(phi) between two polar angles, radians.
inline double largest_sine(double from, double to) {
  return from < 0.5 * kPi && to > 0.5 * kPi ? 1.0 : std::max(std::sin(from), std::sin(to));
}
/// An upper bound on |sin(phi) cos(phi)| between them.
inline double largest_sine_cosine(double from, double to) {
  return largest_sine(from, to) * std::max(std::abs(std::cos(from)), std::abs(std::cos(to)));
}

class AnglePatches {
 public:
  /// Takes the rings from the north to the south. A pole that is not a ring is joined to the nearest ring.
  explicit AnglePatches(std::vector<AngleRing> rings) : rings_(std::move(rings)) {}

  template <class Visit>
  void for_each(Visit&& visit) const {
    if (rings_.front().phi > 0.0) visit_band(0.0, rings_.front().phi, {&rings_.front(), 1}, visit);
    for (std::size_t k = 0; k + 1 < rings_.size(); ++k)
      visit_band(rings_[k].phi, rings_[k + 1].phi, {&rings_[k], 2}, visit);
    if (rings_.back().phi < kPi) visit_band(rings_.back().phi, kPi, {&rings_.back(), 1}, visit);
  }

  Vec3 at(const Patch&, double theta, double phi) const { return to_direction({phi, theta}); }

  PatchMotion motion(const Patch&, const Rect& rect) const {
    const double dtheta = rect.width(0);
    PatchMotion motion;
    motion.way = {dtheta * largest_sine(rect.from[1], rect.to[1]), rect.width(1)};
    motion.turn = {dtheta * dtheta * largest_sine_cosine(rect.from[1], rect.to[1]), 0.0};
    return motion;
  }

 private:
  template <class Visit>
  static void visit_band(double top, double bottom, std::span<const AngleRing> rings, Visit&& visit) {
    std::vector<double> lines{0.0, 2.0 * kPi};
    for (const AngleRing& ring : rings) {
      for (std::size_t k = 0; k < ring.count; ++k)
        lines.push_back(2.0 * kPi * (static_cast<double>(k) + ring.shift) / static_cast<double>(ring.count));
    }
    std::ranges::sort(lines);
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
      if (lines[k + 1] > lines[k]) visit(Patch{0, {{lines[k], top}, {lines[k + 1], bottom}}});
    }
  }

  std::vector<AngleRing> rings_;
};

inline AnglePatches patches_of(const Rsid& scheme) {
  std::vector<AngleRing> rings;
  for (std::size_t i = 0; i < scheme.rows(); ++i) {
    const double phi = i + 1 == scheme.rows() ? kPi : static_cast<double>(i) * scheme.spacing();
    rings.push_back({phi, scheme.columns(), 0.0});
  }
  return AnglePatches(std::move(rings));
}

inline AnglePatches patches_of(const LatitudeRows& scheme) {
  std::vector<AngleRing> rings;
  for (std::size_t i = 0; i < scheme.rows(); ++i) {
    const bool turned = i == 0 || i + 1 == scheme.rows();
    rings.push_back(
        {(static_cast<double>(i) + 0.5) * scheme.row_height(), scheme.row_size(i), turned ? 0.5 : 0.0});
  }
  return AnglePatches(std::move(rings));
}

inline AnglePatches patches_of(const Healpix& scheme) {
  std::vector<AngleRing> rings;
  for (std::size_t k = 0; k < scheme.rings(); ++k) {
    const Ring ring = scheme.ring(k);
    rings.push_back(
        {std::atan2(ring.polar.sin, ring.polar.cos), ring.count, 0.5 * static_cast<double>(ring.half)});
  }
  return AnglePatches(std::move(rings));
}

}  // namespace impinge
