// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the entries near a triangle for schemes whose entries stand on rings of equal latitude, equally
// spaced on each, and are numbered ring by ring from the north.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/angular_box.hpp"
#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// A ring: entries first + t, t = 0 .. count - 1, at the azimuths 2 pi (t + half / 2) / count.
struct RingRow {
  std::size_t first;  // number of its westernmost entry
  std::size_t count;  // of its entries
  std::size_t half;   // 0 or 1

  /// The place of an azimuth (radians) on the ring, in steps from the first entry.
  double position(double theta) const {
    return theta / (2.0 * kPi) * static_cast<double>(count) - 0.5 * static_cast<double>(half);
  }
};

/// A ring with its polar angle.
struct Ring : RingRow {
  CosSin polar;

  /// Unit vector of entry first + t.
  Vec3 direction(std::size_t t) const {
    const CosSin azimuth = half_turn_fraction(static_cast<long>(2 * t + half), static_cast<long>(count));
    return {polar.sin * azimuth.cos, polar.sin * azimuth.sin, polar.cos};
  }
};

inline constexpr double kRingSlack = 1e-6;  // in steps; covers the rounding of places

/// Calls visit(first, count) for the entries between two places of a ring of `of` entries: once, or twice if
/// they lie on both sides of the seam. Places are in steps, and may be on any turn.
template <class Visit>
void for_each_part(double from, double to, std::size_t of, Visit&& visit) {
  const auto all = static_cast<long>(of);
  const auto left = static_cast<long>(std::ceil(from - kRingSlack));
  const auto right = std::min(static_cast<long>(std::floor(to + kRingSlack)), left + all - 1);
  if (left > right) return;
  const auto first = static_cast<std::size_t>(((left % all) + all) % all);
  const std::size_t wanted = static_cast<std::size_t>(right - left) + 1;
  const std::size_t before_seam = std::min(wanted, of - first);
  visit(first, before_seam);
  if (before_seam < wanted) visit(std::size_t{0}, wanted - before_seam);
}

/// The walker of such a scheme S, which has
///   rings()             number of its rings
///   ring(k)             the k-th of its rings, from the north
///   ring_position(phi)  place of a polar angle among the rings, k at ring k; never falls with phi
template <class S>
class RingWalker {
 public:
  explicit RingWalker(const S& scheme) : scheme_(scheme) {}  // takes a copy of the scheme

  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const AngularBox box = angular_box(cone.corners(), margin);
    const double top = std::max(std::ceil(scheme_.ring_position(box.phi_min) - kRingSlack), 0.0);
    const double bottom = std::min(std::floor(scheme_.ring_position(box.phi_max) + kRingSlack),
                                   static_cast<double>(scheme_.rings() - 1));
    for (double k = top; k <= bottom; k += 1.0) {
      const Ring ring = scheme_.ring(static_cast<std::size_t>(k));
      const double from = ring.position(box.theta_min);
      const double to = ring.position(box.theta_min + box.theta_width);
      for_each_part(from, to, ring.count, [&](std::size_t first, std::size_t count) {
        const auto direction_of = [&](std::size_t t) { return ring.direction(first + t); };
        visit_in_runs(ring.first + first, count, direction_of, visit);
      });
    }
  }

 private:
  S scheme_;
};

}  // namespace impinge
