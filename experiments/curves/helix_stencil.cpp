// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/helix_stencil.hpp"

#include <algorithm>
#include <cmath>

#include "curves/helix_length.hpp"

namespace impinge {
namespace {

// Two entries and the share of the second.
struct Between {
  std::size_t entry;
  double share;
};

Between on_turn(const HelixEntries& entries, HelixIndex index, double phi) {
  const double place = helix_place(entries, index, phi);
  const std::size_t entry = std::min(static_cast<std::size_t>(place), entries.count - 2);
  return {entry, place - static_cast<double>(entry)};
}

double share_of_curve(const HelixEntries& entries, HelixIndex index, double phi) {
  const double turns = entries.turns;
  if (index == HelixIndex::true_arc) return helix_length(turns, phi) / helix_total_length(turns);
  return travelled_distance(turns, phi) / (index == HelixIndex::eq10_true_spacing
                                               ? helix_total_length(turns)
                                               : total_travelled_distance(turns));
}

}  // namespace

double helix_place(const HelixEntries& entries, HelixIndex index, double phi) {
  return last_index(entries) * std::min(share_of_curve(entries, index, phi), 1.0);
}

Stencil helix_stencil(const HelixEntries& entries, HelixIndex index, const Vec3& x) {
  const Angles at = to_angles(x);
  const double slope = 2.0 * entries.turns;
  const double above = std::floor((slope * at.phi - at.theta) / (2.0 * kPi));
  const double phi_a = (at.theta + 2.0 * kPi * above) / slope;
  const double phi_b = (at.theta + 2.0 * kPi * (above + 1.0)) / slope;
  if (phi_a < 0.0) {
    const Between b = on_turn(entries, index, phi_b);
    const double down = std::min(at.phi / phi_b, 1.0);
    return {{0, b.entry, b.entry + 1}, {1.0 - down, down * (1.0 - b.share), down * b.share}, 3, 0};
  }
  const Between a = on_turn(entries, index, std::min(phi_a, kPi));
  if (phi_b > kPi) {
    const double down = phi_a < kPi ? std::clamp((at.phi - phi_a) / (kPi - phi_a), 0.0, 1.0) : 0.0;
    return {{a.entry, a.entry + 1, entries.count - 1},
            {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down},
            3,
            0};
  }
  const Between b = on_turn(entries, index, phi_b);
  const double down = std::clamp((at.phi - phi_a) / (phi_b - phi_a), 0.0, 1.0);
  return {{a.entry, a.entry + 1, b.entry, b.entry + 1},
          {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down * (1.0 - b.share), down * b.share},
          4,
          0};
}

}  // namespace impinge
