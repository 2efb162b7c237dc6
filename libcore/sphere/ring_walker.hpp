// SPDX-License-Identifier: GPL-3.0-or-later
// Schemes whose entries stand on rings of equal latitude, equally spaced on each, numbered ring by ring from
// the north.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/angular_box.hpp"
#include "sphere/direction.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// Entries first .. first + count - 1 at the polar angle `polar` and azimuths 2 pi (t + half / 2) / count.
struct Ring {
  std::size_t first;  // number of its westernmost entry
  std::size_t count;  // of its entries
  std::size_t half;   // 0 or 1
  CosSin polar;       // of its polar angle

  /// Unit vector of entry first + t.
  Vec3 direction(std::size_t t) const {
    const CosSin azimuth = half_turn_fraction(static_cast<long>(2 * t + half), static_cast<long>(count));
    return {polar.sin * azimuth.cos, polar.sin * azimuth.sin, polar.cos};
  }

  /// Place of an azimuth on the ring, in steps from the first entry; radians.
  double position(double theta) const {
    return theta / (2.0 * kPi) * static_cast<double>(count) - 0.5 * static_cast<double>(half);
  }
};

/// Walker of such a scheme S, which has
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
    const double top = std::max(std::ceil(scheme_.ring_position(box.phi_min) - kSlack), 0.0);
    const double bottom = std::min(std::floor(scheme_.ring_position(box.phi_max) + kSlack),
                                   static_cast<double>(scheme_.rings() - 1));
    for (double k = top; k <= bottom; k += 1.0)
      visit_part(scheme_.ring(static_cast<std::size_t>(k)), box, visit);
  }

 private:
  static constexpr double kSlack = 1e-6;  // of a step: rounding of the positions

  template <class Visit>
  static void visit_part(const Ring& ring, const AngularBox& box, Visit&& visit) {
    const auto count = static_cast<long>(ring.count);
    const auto left = static_cast<long>(std::ceil(ring.position(box.theta_min) - kSlack));
    const auto right =
        std::min(static_cast<long>(std::floor(ring.position(box.theta_min + box.theta_width) + kSlack)),
                 left + count - 1);
    if (left > right) return;
    const auto first = static_cast<std::size_t>(((left % count) + count) % count);
    const std::size_t wanted = static_cast<std::size_t>(right - left) + 1;
    const std::size_t before_seam = std::min(wanted, ring.count - first);
    visit_entries(ring, first, before_seam, visit);
    visit_entries(ring, 0, wanted - before_seam, visit);
  }

  template <class Visit>
  static void visit_entries(const Ring& ring, std::size_t first, std::size_t wanted, Visit&& visit) {
    DirectionRun run;
    for (std::size_t done = 0; done < wanted; done += run.count) {
      run.first = ring.first + first + done;
      run.count = std::min(wanted - done, DirectionRun::kMost);
      for (std::size_t k = 0; k < run.count; ++k) {
        const Vec3 u = ring.direction(first + done + k);
        run.x[k] = u.x();
        run.y[k] = u.y();
        run.z[k] = u.z();
      }
      visit(static_cast<const DirectionRun&>(run));
    }
  }

  S scheme_;
};

}  // namespace impinge
