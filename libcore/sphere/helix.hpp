// SPDX-License-Identifier: GPL-3.0-or-later
// A spherical helix theta = slope * phi (thesis, Eq. 9, with slope = 2 k) whose w entries stand at equal
// steps of height: cos(phi_i) = 1 - 2 i / (w - 1), i = 0 ... w - 1, both poles included. What Usid and
// HelixIsotropic share.
//
// The place of a point of the curve, counted in entries, is t(phi) = (w - 1) (1 - cos phi) / 2. Turns are
// 2 pi / slope apart. All angles in radians.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sphere/angular_box.hpp"
#include "sphere/direction.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

class Helix {
 public:
  Helix() = default;

  // size >= 4 entries, slope >= 4: two turns.
  Helix(std::size_t size, double slope) : size_(size), slope_(slope) {
    stencil_radius_ = find_stencil_radius();
    covering_radius_ = find_covering_radius();
  }

  std::size_t size() const { return size_; }
  // Cells are numbered along the strip between consecutive turns: see cell_of().
  std::size_t cells() const { return 2 * size_ - 1; }
  double slope() const { return slope_; }
  double turn_spacing() const { return 2.0 * kPi / slope_; }
  double covering_radius() const { return covering_radius_; }
  double stencil_radius() const { return stencil_radius_; }

  // t(phi), and phi(t), which is accurate at both poles.
  double place(double phi) const {
    const double half = std::sin(0.5 * phi);
    return last() * half * half;
  }
  double polar_angle(double t) const { return 2.0 * std::atan2(std::sqrt(t), std::sqrt(last() - t)); }

  Vec3 direction(std::size_t entry) const {
    const auto i = static_cast<double>(entry);
    const double sin_phi = 2.0 * std::sqrt(i * (last() - i)) / last();
    const double theta = slope_ * polar_angle(i);
    return {sin_phi * std::cos(theta), sin_phi * std::sin(theta), (last() - 2.0 * i) / last()};
  }

  // Algorithm 3: linear along the turn above at the query's theta (point P_a, two entries round it) and along
  // the turn below (P_b), then linear in phi between P_a and P_b. Above the first turn and below the last one
  // the pole stands for the missing turn, three taps.
  Stencil stencil(const Vec3& x) const {
    const auto [phi, theta] = to_angles(x);
    const double turns = (slope_ * phi - theta) / (2.0 * kPi);
    const double above = std::max(std::floor(turns), -1.0);
    const double phi_a = (theta + 2.0 * kPi * above) / slope_;
    const double phi_b = (theta + 2.0 * kPi * (above + 1.0)) / slope_;
    if (above < 0.0) return first_turn(std::min(phi / phi_b, 1.0), on_turn(phi_b));
    if (phi_b > kPi) {
      const double share = phi_a < kPi ? std::clamp((phi - phi_a) / (kPi - phi_a), 0.0, 1.0) : 0.0;
      return last_turn(share, on_turn(phi_a));
    }
    return between(on_turn(phi_a), on_turn(phi_b), std::min(turns - above, 1.0));
  }

  // Entries of one turn do not stand below those of the next, so that a cell reads entries beyond its
  // corners: from any direction there is a way to each tap, no longer than stencil_radius(), through the
  // cells that have the same interval above or the same interval below. Calls visit(stencil) for all of
  // these; the weights are of no meaning.
  template <class Visit>
  void for_each_cell_across(const Stencil& at, Visit&& visit) const {
    const bool first = at.taps == 3 && at.entry[2] == at.entry[1] + 1;
    const bool last = at.taps == 3 && !first;
    if (!first) visit_below({at.entry[0], 0.0}, visit);
    if (!last) visit_above({at.entry[first ? 1 : 2], 0.0}, visit);
  }

  // Runs of the turns that cross the box round the cone.
  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const AngularBox box = angular_box(cone.corners(), margin);
    std::size_t next = 0;  // no entry twice where rounding makes turns overlap
    if (box.theta_width >= 2.0 * kPi) return visit_arc(box.phi_min, box.phi_max, next, visit);
    const double theta_max = box.theta_min + box.theta_width;
    const double top = std::floor((slope_ * box.phi_min - theta_max) / (2.0 * kPi));
    const double bottom = std::ceil((slope_ * box.phi_max - box.theta_min) / (2.0 * kPi));
    for (double turn = top; turn <= bottom; turn += 1.0) {
      visit_arc(std::max(box.phi_min, (box.theta_min + 2.0 * kPi * turn) / slope_),
                std::min(box.phi_max, (theta_max + 2.0 * kPi * turn) / slope_), next, visit);
    }
  }

  friend bool operator==(const Helix& a, const Helix& b) {
    return a.size_ == b.size_ && a.slope_ == b.slope_;
  }

 private:
  // A point of the curve between entries `entry` and entry + 1.
  struct Between {
    std::size_t entry;
    double share;
  };

  // Entries that are treated one by one at each pole, where turns are strongly curved.
  static constexpr double kPolarEntries = 64.0;

  double last() const { return static_cast<double>(size_ - 1); }

  Between on_turn(double phi) const {
    const double t = place(phi);
    const std::size_t i = std::min(static_cast<std::size_t>(t), size_ - 2);
    return {i, std::clamp(t - static_cast<double>(i), 0.0, 1.0)};
  }

  // The strip between two turns is one spiral ribbon from pole to pole. Along it neither the interval a of
  // the turn above nor the interval b of the turn below ever falls, and a cell is where both stay the same.
  // Where the turn above is missing its pole counts as interval -1, where the one below is, as size - 1.
  static std::size_t cell_of(std::size_t a_after, std::size_t b) { return a_after + b; }

  static Stencil between(Between a, Between b, double down) {
    return {{a.entry, a.entry + 1, b.entry, b.entry + 1},
            {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down * (1.0 - b.share), down * b.share},
            4,
            cell_of(a.entry + 1, b.entry)};
  }
  static Stencil first_turn(double down, Between b) {
    return {{0, b.entry, b.entry + 1, 0},
            {1.0 - down, down * (1.0 - b.share), down * b.share, 0.0},
            3,
            cell_of(0, b.entry)};
  }
  Stencil last_turn(double down, Between a) const {
    return {{a.entry, a.entry + 1, size_ - 1, 0},
            {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down, 0.0},
            3,
            cell_of(a.entry + 1, size_ - 1)};
  }

  // All cells between interval a and the turn below it, between interval b and the turn above it.
  template <class Visit>
  void visit_below(Between a, Visit&& visit) const {
    const double from = polar_angle(static_cast<double>(a.entry)) + turn_spacing();
    const double to = polar_angle(static_cast<double>(a.entry + 1)) + turn_spacing();
    if (to >= kPi) visit(last_turn(0.0, a));
    if (from > kPi) return;
    const Between end = on_turn(std::min(to, kPi));
    for (Between b = on_turn(from); b.entry <= end.entry; ++b.entry) visit(between(a, b, 0.0));
  }
  template <class Visit>
  void visit_above(Between b, Visit&& visit) const {
    const double from = polar_angle(static_cast<double>(b.entry)) - turn_spacing();
    const double to = polar_angle(static_cast<double>(b.entry + 1)) - turn_spacing();
    if (from <= 0.0) visit(first_turn(0.0, b));
    if (to < 0.0) return;
    const Between end = on_turn(to);
    for (Between a = on_turn(std::max(from, 0.0)); a.entry <= end.entry; ++a.entry) visit(between(a, b, 0.0));
  }

  template <class Visit>
  void visit_arc(double phi_min, double phi_max, std::size_t& next, Visit&& visit) const {
    if (phi_min > phi_max) return;
    const double slack = 1e-6 + 1e-15 * last();  // rounding of place(), in entries
    const double from = std::ceil(std::max(place(phi_min) - slack, 0.0));
    const double to = std::floor(std::min(place(phi_max) + slack, last()));
    if (from > to) return;
    const std::size_t end = static_cast<std::size_t>(to) + 1;
    DirectionRun run;
    for (next = std::max(next, static_cast<std::size_t>(from)); next < end; next += run.count) {
      run.first = next;
      run.count = std::min(end - next, DirectionRun::kMost);
      for (std::size_t k = 0; k < run.count; ++k) {
        const Vec3 u = direction(next + k);
        run.x[k] = u.x();
        run.y[k] = u.y();
        run.z[k] = u.z();
      }
      visit(static_cast<const DirectionRun&>(run));
    }
  }

  // Of the northern half (the southern one mirrors it): the direction farthest from entry i is at the far
  // corner of its ribbon, one turn below the next entry. Beyond the polar entries, with step d = phi(i + 1) -
  // phi(i), the way there is at most turn spacing + d along phi and slope sin(phi) d <= slope (2 / (w - 1) +
  // d (d + turn spacing)) across; both fall towards the equator.
  double find_stencil_radius() const {
    if (slope_ < 5.0) return kPi;  // two turns and six entries at most: some stencils span the sphere
    double largest = 0.0;
    const double count = std::min(kPolarEntries, last());
    for (double i = 0.0; i < count; i += 1.0) largest = std::max(largest, way_to_far_corner(i));
    if (last() > 2.0 * kPolarEntries) {
      const double step = polar_angle(count + 1.0) - polar_angle(count);
      const double along = step + turn_spacing();
      largest = std::max(largest, std::hypot(along, slope_ * (2.0 / last() + step * along)));
    }
    return largest;
  }

  // Length of a way from entry i to the far corner of its ribbon that does not leave the ribbon: along the
  // turn, as far as the pole is in the way, and then straight. Near a pole that is longer than the way across
  // it.
  double way_to_far_corner(double i) const {
    const double phi = polar_angle(i);
    const double next = polar_angle(i + 1.0);
    const double corner = std::min(next + turn_spacing(), kPi);
    for (int part = 0;; ++part) {
      const double from = phi + (next - phi) * part / 16.0;
      const double apart = slope_ * (next - from);
      const double down =
          std::cos(from) * std::sin(corner) * std::cos(apart) - std::sin(from) * std::cos(corner);
      const double ahead = std::sin(corner) * std::sin(apart);
      if (part < 16 && i > 0.0 && down * slope_ * std::sin(from) < ahead) continue;
      return std::hypot(from - phi, slope_ * std::sin(from) * (from - phi)) + separation(from, corner, apart);
    }
  }

  // The larger of the gap at the pole, found exactly, and that of the rest, where the entries of the turns
  // above and below may be in any phase to each other: worst_gap(), which falls towards the equator.
  double find_covering_radius() const {
    const double reach = 1.5 * worst_gap(0.5 * (kPi - turn_spacing()));
    const double cap = polar_angle(std::min(kPolarEntries, last()));
    const double taken = std::min(std::floor(place(std::min(cap + 2.0 * reach, kPi))), last());
    std::vector<Vec3> polar;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(taken); ++i) polar.push_back(direction(i));
    double gap = largest_gap(polar, std::cos(cap), reach);
    if (last() > 2.0 * kPolarEntries) {
      gap = std::max({gap, worst_gap(cap - turn_spacing()), worst_gap(0.5 * (kPi - turn_spacing()))});
    }
    return gap * (1.0 + 1e-9);
  }

  // Largest distance from a direction between the turns through phi_a and phi_a + turn spacing (at one theta)
  // to the nearest entry, at the worst places of entries on each: halving finds where both are as far.
  double worst_gap(double phi_a) const {
    double low = phi_a;
    double high = phi_a + turn_spacing();
    for (int k = 0; k < 50; ++k) {
      const double phi = 0.5 * (low + high);
      (worst_on_turn(phi, phi_a) < worst_on_turn(phi, phi_a + turn_spacing()) ? low : high) = phi;
    }
    return worst_on_turn(high, phi_a);
  }

  // Distance of the direction at phi from the nearer of two entries one step apart on the turn that passes
  // its theta at phi_turn, where these are as far as they can be.
  double worst_on_turn(double phi, double phi_turn) const {
    const auto away = [&](double t) {
      const double entry = polar_angle(std::clamp(t, 0.0, last()));
      return separation(phi, entry, slope_ * (phi_turn - entry));
    };
    const double t = place(phi_turn);
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < 50; ++k) {
      const double back = 0.5 * (low + high);
      (away(t - back) < away(t - back + 1.0) ? low : high) = back;
    }
    return away(t - high);
  }

  std::size_t size_ = 4;
  double slope_ = 4.0;
  double covering_radius_ = kPi;
  double stencil_radius_ = kPi;
};

}  // namespace impinge
