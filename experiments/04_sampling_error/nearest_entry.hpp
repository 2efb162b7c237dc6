// SPDX-License-Identifier: GPL-3.0-or-later
// How far along the sphere the entries of a scheme are: what Eq. 7 of the thesis is about.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "sphere/scheme.hpp"
#include "sphere/walker.hpp"

namespace impinge::lab {

// The entry nearest to a direction.
struct NearestEntry {
  std::size_t entry = 0;  // number of the entry
  double angle = 0.0;     // radians from the direction
};

// Finds nearest entries of one scheme. Keeps the scratch memory of a walker.
template <SamplingScheme S>
class NearestEntryFinder {
 public:
  // Takes the scheme's walker.
  explicit NearestEntryFinder(const S& scheme)
      : walker_(walker_of(scheme)), reach_(scheme.covering_radius() * (1.0 + 1e-9)) {}

  // u a unit vector. Throws std::logic_error if no entry is within the declared covering radius.
  NearestEntry operator()(const Vec3& u) const {
    double nearest = std::numeric_limits<double>::infinity();  // squared length of the chord
    NearestEntry found;
    walker_.visit_near(TriangleCone(u, u, u), reach_, [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k) {
        const double chord = (run[k] - u).squaredNorm();
        if (chord < nearest) {
          nearest = chord;
          found.entry = run.first + k;
        }
      }
    });
    found.angle = 2.0 * std::asin(0.5 * std::sqrt(std::min(nearest, 4.0)));
    if (!(found.angle <= reach_)) {
      throw std::logic_error("scheme '" + std::string(S::name) + "' has no entry within " +
                             std::to_string(reach_ / kDegree) +
                             " degrees of a direction: its covering radius is wrong");
    }
    return found;
  }

 private:
  decltype(walker_of(std::declval<const S&>())) walker_;
  double reach_;
};

// Nearest entry of each direction.
template <SamplingScheme S>
std::vector<NearestEntry> nearest_entries(const S& scheme, std::span<const Vec3> directions) {
  const NearestEntryFinder<S> finder(scheme);
  std::vector<NearestEntry> nearest;
  nearest.reserve(directions.size());
  for (const Vec3& u : directions) nearest.push_back(finder(u));
  return nearest;
}

// A direction far from all entries, and how far it is from the nearest one.
struct Gap {
  Vec3 direction = Vec3::UnitZ();  // unit vector
  double angle = 0.0;              // radians
};

// Moves u uphill, away from all entries, by ever smaller steps.
template <SamplingScheme S>
Gap climb_away(const NearestEntryFinder<S>& finder, Vec3 u) {
  double here = finder(u).angle;
  for (double step = 0.3 * here; step > 1e-4 * here; step *= 0.6) {
    const Vec3 east = u.unitOrthogonal();
    const Vec3 north = u.cross(east);
    for (int k = 0; k < 8; ++k) {
      const double angle = 0.25 * kPi * k;
      const Vec3 v = (u + step * (std::cos(angle) * east + std::sin(angle) * north)).normalized();
      const double there = finder(v).angle;
      if (there > here) {
        here = there;
        u = v;
      }
    }
  }
  return {u, here};
}

// Largest angle from a direction to its nearest entry, as it is found by climbing from those of the
// directions that are farthest from theirs; `nearest` are the directions' nearest_entries(). Never above the
// covering radius, and within 1e-3 of it where the directions are dense enough to find the widest gap.
template <SamplingScheme S>
Gap widest_gap(const S& scheme, std::span<const Vec3> directions, std::span<const NearestEntry> nearest) {
  constexpr std::size_t climbs = 64;
  std::vector<std::size_t> order(directions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(std::min(climbs, order.size()));
  std::partial_sort(order.begin(), last, order.end(),
                    [&nearest](std::size_t a, std::size_t b) { return nearest[a].angle > nearest[b].angle; });
  const NearestEntryFinder<S> finder(scheme);
  Gap widest;
  for (auto start = order.begin(); start != last; ++start) {
    const Gap gap = climb_away(finder, directions[*start]);
    if (gap.angle > widest.angle) widest = gap;
  }
  return widest;
}

}  // namespace impinge::lab
