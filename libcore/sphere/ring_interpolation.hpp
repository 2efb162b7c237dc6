// SPDX-License-Identifier: GPL-3.0-or-later
// What LatitudeRows and Healpix share: entries on rings of latitude, and a look-up that is linear along the
// two rings next to the query and then linear in the polar angle. Within the first and the last ring the pole
// stands for the missing ring, with the mean of the ring's entries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/ring_walker.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// Base of such a scheme S, which has what RingWalker asks for, and
///   row(k)          the k-th ring without its polar angle; the first and the last have 3 or 4 entries
///   polar_angle(k)  polar angle of the ring, radians
///   ring_of(entry)  the ring that an entry is on
template <class S>
class RingInterpolation {
 public:
  /// Number of cells: one for each cap, and between two rings as many as both have entries.
  std::size_t cells() const { return 2 * self().size() - 2 * self().row(0).count + 2; }

  /// Calls visit(stencil) for all cells that have the same gap above or the same gap below as the cell of
  /// `at`; ignore their weights. Entries of one ring do not stand below entries of the next, so that a cell
  /// reads entries beyond its corners. Through these cells there is a way, no longer than stencil_radius(),
  /// from any direction to each tap.
  template <class Visit>
  void for_each_cell_across(const Stencil& at, Visit&& visit) const {
    if (at.cell == 0 || at.cell == cells() - 1) return;
    const std::size_t k = self().ring_of(at.entry[0]);
    const auto visit_middle = [&](double theta) { visit(between(k, theta, 0.0)); };
    for_each_overlap(self().row(k), at.entry[0], self().row(k + 1), visit_middle);
    for_each_overlap(self().row(k + 1), at.entry[2], self().row(k), visit_middle);
  }

  /// Cells lie between parallels and meridians.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return latitude_is_monotone(a, b); }

  RingWalker<S> walker() const { return RingWalker(self()); }

  friend bool operator==(const RingInterpolation&, const RingInterpolation&) = default;

 protected:
  /// The stencil between rings k and k + 1; `down` goes from 0 on the upper one to 1 on the lower one.
  Stencil between(std::size_t k, double theta, double down) const {
    const RingRow upper = self().row(k);
    const RingRow lower = self().row(k + 1);
    const Gap a = gap(upper, theta);
    const Gap b = gap(lower, theta);
    // If both gaps cross theta = 0, so does the cell, and its last number is its first.
    const std::size_t step = (a.step + b.step) % (upper.count + lower.count);
    return {{upper.first + a.left, upper.first + a.right, lower.first + b.left, lower.first + b.right},
            {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down * (1.0 - b.share), down * b.share},
            4,
            upper.first + lower.first + 1 - self().row(0).count + step};
  }

  /// The stencil within ring k, the first or the last; `outwards` goes from 0 at the pole to 1 on the ring.
  Stencil cap_stencil(std::size_t k, double outwards, double theta) const {
    const RingRow on = self().row(k);
    const Gap at = gap(on, theta);
    const double w = std::clamp(outwards, 0.0, 1.0);
    Stencil stencil{{}, {}, on.count, k == 0 ? 0 : cells() - 1};
    for (std::size_t t = 0; t < on.count; ++t) {
      stencil.entry[t] = on.first + t;
      stencil.weight[t] = (1.0 - w) / static_cast<double>(on.count);
    }
    stencil.weight[at.left] += w * (1.0 - at.share);
    stencil.weight[at.right] += w * at.share;
    return stencil;
  }

  /// The longest way, between the two rings, from an entry of ring k or k + 1 (northern half) to the far end
  /// of a gap of the other: along the ring nearer to the pole while the pole is in the way, then straight.
  double way_across(std::size_t k) const {
    const std::size_t fewer = std::min(self().row(k).count, self().row(k + 1).count);
    const double gap = 2.0 * kPi / static_cast<double>(fewer);
    const double upper = self().polar_angle(k);
    const double lower = self().polar_angle(k + 1);
    const double seen = lower < 0.5 * kPi ? std::acos(std::tan(upper) / std::tan(lower)) : 0.5 * kPi;
    const double straight = std::min(gap, seen);
    return std::sin(upper) * (gap - straight) + separation(upper, lower, straight);
  }

 private:
  friend S;
  RingInterpolation() = default;

  /// The gap of a ring that holds an azimuth: the entries left and right of the azimuth, the number of gaps
  /// begun since theta = 0, and how far into the gap it is, from 0 to 1.
  struct Gap {
    std::size_t left;
    std::size_t right;
    std::size_t step;
    double share;
  };

  static Gap gap(const RingRow& row, double theta) {
    const double place = row.position(theta);
    const double left = std::min(std::floor(place), static_cast<double>(row.count) - 1.0);
    const std::size_t step = static_cast<std::size_t>(left + static_cast<double>(row.half));
    const std::size_t entry = (step + row.count - row.half) % row.count;
    return {entry, (entry + 1) % row.count, step, std::min(place - left, 1.0)};
  }

  /// Calls visit(theta) with the middle of each stretch that the gap right of an entry shares with a gap of
  /// the other ring.
  template <class Visit>
  static void for_each_overlap(const RingRow& row, std::size_t entry, const RingRow& other, Visit&& visit) {
    const double step = 2.0 * kPi / static_cast<double>(row.count);
    const double other_step = 2.0 * kPi / static_cast<double>(other.count);
    const double from = (static_cast<double>(entry - row.first) + 0.5 * static_cast<double>(row.half)) * step;
    const double to = from + step;
    const double half = 0.5 * static_cast<double>(other.half);
    for (double left = std::floor(other.position(from)); (left + half) * other_step < to; left += 1.0) {
      const double begin = std::max(from, (left + half) * other_step);
      const double end = std::min(to, (left + 1.0 + half) * other_step);
      if (end - begin < 1e-6 * other_step) continue;  // they only touch
      visit(std::fmod(0.5 * (begin + end), 2.0 * kPi));
    }
  }

  const S& self() const { return static_cast<const S&>(*this); }
};

}  // namespace impinge
