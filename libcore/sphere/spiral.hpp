// SPDX-License-Identifier: GPL-3.0-or-later
// What Usid, UsidArc, HelixIsotropic and Conchoid share: their entries stand on one curve that winds from the
// north pole to the south pole. Where on it they stand, the placement of each says.
//
// A placement P is a regular value with two coordinates of the polar angle phi, both rising: the turn (turns
// of azimuth that the curve has made from the north pole) and the place (entries that it has passed, whole at
// an entry).
//   last()               place of the south pole; last() + 1 entries
//   turns()              turn of the south pole, at least 2
//   turn(phi)            turn at the polar angle phi
//   polar_of_turn(turn)  polar angle of a turn, the inverse of turn()
//   most_turn_rate()     largest derivative of turn(phi), and
//   most_turn_bend()     largest second derivative, absolute
//   place(phi)           place at the polar angle phi
//   polar_angle(t)       polar angle of the place t, the inverse of place(), accurate at both poles
//   direction(i)         unit vector of entry i
//   kMirrored            whether the southern half is the mirror image of the northern one
// and may have, where it is faster
//   fill(run)            fills a run whose `first` and `count` are set, with the numbers of direction()
//   area(i)              solid angle that the entry stands for, steradians, 4 pi in all
// The curve's azimuth at phi is 2 pi turn(phi). All angles in radians.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sphere/angular_box.hpp"
#include "sphere/arc_borders.hpp"
#include "sphere/direction.hpp"
#include "sphere/haversine.hpp"
#include "sphere/scheme.hpp"
#include "sphere/spiral_radii.hpp"
#include "sphere/turn_clip.hpp"

namespace impinge {

template <class P>
class Spiral {
 public:
  /// Finds the covering radius and the stencil radius, once.
  explicit Spiral(const P& placement) : placement_(placement) {
    stencil_radius_ = spiral_stencil_radius(placement_);
    covering_radius_ = spiral_covering_radius(placement_);
  }

  std::size_t size() const { return static_cast<std::size_t>(last()) + 1; }
  /// Cells are numbered along the strip between consecutive turns: see cell_of().
  std::size_t cells() const { return 2 * size() - 1; }
  double covering_radius() const { return covering_radius_; }
  double stencil_radius() const { return stencil_radius_; }

  Vec3 direction(std::size_t entry) const { return placement_.direction(entry); }
  /// Solid angle of the band from half a place before an entry to half a place after it, with sin^2(a / 2) -
  /// sin^2(b / 2) = sin((a + b) / 2) sin((a - b) / 2).
  double area(std::size_t entry) const {
    if constexpr (requires { placement_.area(entry); }) {
      return placement_.area(entry);
    } else {
      const auto i = static_cast<double>(entry);
      const double from = placement_.polar_angle(std::max(i - 0.5, 0.0));
      const double to = placement_.polar_angle(std::min(i + 0.5, last()));
      return 4.0 * kPi * std::sin(0.5 * (from + to)) * std::sin(0.5 * (to - from));
    }
  }

  /// Entries that the curve has passed at polar angle phi, between entries a fraction.
  double place(double phi) const { return placement_.place(phi); }

  /// Algorithm 3: linear along the turn above at the query's theta (point P_a, two entries round it) and
  /// along the turn below (P_b), then linear in the turn between P_a and P_b. Above the first turn and below
  /// the last one the pole stands for the missing turn, three taps.
  Stencil stencil(const Vec3& x) const {
    const auto on_turn = [&](double turn) { return between_entries(place(polar_of_turn(turn))); };
    const auto [phi, theta] = to_angles(x);
    const double azimuth = theta / (2.0 * kPi);
    const double turn = placement_.turn(phi);
    const double above = std::max(std::floor(turn - azimuth), -1.0);
    const double turn_a = above + azimuth;
    const double turn_b = turn_a + 1.0;
    if (above < 0.0) return first_turn(std::min(turn / turn_b, 1.0), on_turn(turn_b));
    if (turn_b > placement_.turns()) {
      const double left = placement_.turns() - turn_a;
      return last_turn(left > 0.0 ? std::clamp((turn - turn_a) / left, 0.0, 1.0) : 0.0, on_turn(turn_a));
    }
    return four_taps(on_turn(turn_a), on_turn(turn_b), std::clamp(turn - turn_a, 0.0, 1.0));
  }

  /// Calls visit(stencil) for all cells that have the same interval above or the same interval below as the
  /// cell of `at`; ignore their weights. Entries of one turn do not stand below entries of the next, so that
  /// a cell reads entries beyond its corners. Through these cells there is a way, no longer than
  /// stencil_radius(), from any direction to each tap.
  template <class Visit>
  void for_each_cell_across(const Stencil& at, Visit&& visit) const {
    const bool first = at.taps == 3 && at.entry[2] == at.entry[1] + 1;
    const bool last = at.taps == 3 && !first;
    if (!first) visit_below({at.entry[0], 0.0}, visit);
    if (!last) visit_above({at.entry[first ? 1 : 2], 0.0}, visit);
  }

  /// Cells lie between meridians and the curve, on which turn(phi) - theta / (2 pi) is whole. By ArcAngles
  /// this coordinate has a second derivative of at most T' |cot phi| + T'' + |cot phi| / (2 pi sin(phi)). An
  /// arc of at most a sixteenth of a turn of azimuth meets the azimuths of a cell once, as no two
  /// neighbouring entries are 15/16 of a turn apart.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const {
    const ArcAngles arc(a, b);
    if (arc.sine == 0.0 || std::abs(arc.turn) > kPi / 8.0) return false;
    const double bend = (placement_.most_turn_rate() + 1.0 / (2.0 * kPi * arc.sine)) * arc.cotangent() +
                        placement_.most_turn_bend();
    const double from = placement_.turn(arc.from.phi) - arc.from.theta / (2.0 * kPi);
    const double change =
        placement_.turn(arc.to.phi) - placement_.turn(arc.from.phi) - arc.turn / (2.0 * kPi);
    return passes_lines_once(from, from + change, bend * arc.length * arc.length);
  }

  const P& placement() const { return placement_; }  // where the entries are

  const Spiral& walker() const { return *this; }

  /// Visits the stretches of turns that TurnClip leaves within the box round the cone.
  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const AngularBox box = angular_box(cone.corners(), margin);
    const TurnClip clip(cone, box, {margin, kPi / placement_.turns(), kDoubt * (1.0 + placement_.turns())});
    const double west = clip.azimuth(0);
    const double east = clip.azimuth(clip.pieces());
    const double rounding = kDoubt * (1.0 + placement_.turns());
    const double top = std::ceil(placement_.turn(box.phi_min) - east - rounding);
    const double bottom = std::floor(placement_.turn(box.phi_max) - west + rounding);
    Range range{place(box.phi_min), place(box.phi_max), 0};
    for (double turn = top; turn <= bottom; turn += 1.0) {
      const double phi_west = polar_of_turn(turn + west);
      const double phi_east = polar_of_turn(turn + east);
      const double hav = haversine(0.5 * (phi_west + phi_east));
      const CosSin polar{1.0 - 2.0 * hav, 2.0 * std::sqrt(hav * (1.0 - hav))};
      const TurnClip::Turn here{polar, phi_east - phi_west};
      for (std::size_t k = 0; k < clip.pieces(); ++k) {
        const TurnClip::Part part = clip.part(k, here);
        if (part.from > part.to) continue;
        const double from = turn + clip.azimuth(k);
        const double width = turn + clip.azimuth(k + 1) - from;
        visit_piece(from + part.from * width, from + part.to * width, range, visit);
      }
    }
  }

  friend bool operator==(const Spiral& a, const Spiral& b) { return a.placement_ == b.placement_; }

 private:
  /// A point of the curve between entries `entry` and entry + 1.
  struct Between {
    std::size_t entry;
    double share;
  };

  /// Places that a walker may visit, and the first entry that it has not visited: where rounding makes pieces
  /// overlap, no entry is visited twice.
  struct Range {
    double from;
    double to;
    std::size_t next;
  };

  /// An entry is within kDoubt (1 + turns()) radians of its place in exact arithmetic.
  static constexpr double kDoubt = 1e-14;

  double last() const { return placement_.last(); }
  double polar_of_turn(double turn) const {
    return placement_.polar_of_turn(std::clamp(turn, 0.0, placement_.turns()));
  }

  Between between_entries(double t) const {
    const std::size_t i = std::min(static_cast<std::size_t>(t), size() - 2);
    return {i, std::clamp(t - static_cast<double>(i), 0.0, 1.0)};
  }
  Between on_turn(double turn) const { return between_entries(place(polar_of_turn(turn))); }

  /// Number of a cell. The strip between consecutive turns is one spiral ribbon from pole to pole. Along it
  /// the interval a of the turn above and the interval b of the turn below never fall, and a cell is where
  /// both stay the same. If the turn above is missing, the pole counts as interval -1; if the turn below is,
  /// as size - 1.
  static std::size_t cell_of(std::size_t a_after, std::size_t b) { return a_after + b; }

  static Stencil four_taps(Between a, Between b, double down) {
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
    return {{a.entry, a.entry + 1, size() - 1, 0},
            {(1.0 - down) * (1.0 - a.share), (1.0 - down) * a.share, down, 0.0},
            3,
            cell_of(a.entry + 1, size() - 1)};
  }

  double turn_of_entry(std::size_t entry) const {
    return placement_.turn(placement_.polar_angle(static_cast<double>(entry)));
  }

  /// Visits all cells between interval a and the turn below; visit_above() likewise for interval b.
  template <class Visit>
  void visit_below(Between a, Visit&& visit) const {
    const double from = turn_of_entry(a.entry) + 1.0;
    const double to = turn_of_entry(a.entry + 1) + 1.0;
    if (to >= placement_.turns()) visit(last_turn(0.0, a));
    if (from > placement_.turns()) return;
    const Between end = on_turn(to);
    for (Between b = on_turn(from); b.entry <= end.entry; ++b.entry) visit(four_taps(a, b, 0.0));
  }
  template <class Visit>
  void visit_above(Between b, Visit&& visit) const {
    const double from = turn_of_entry(b.entry) - 1.0;
    const double to = turn_of_entry(b.entry + 1) - 1.0;
    if (from <= 0.0) visit(first_turn(0.0, b));
    if (to < 0.0) return;
    const Between end = on_turn(to);
    for (Between a = on_turn(from); a.entry <= end.entry; ++a.entry) visit(four_taps(a, b, 0.0));
  }

  template <class Visit>
  void visit_piece(double turn_from, double turn_to, Range& range, Visit&& visit) const {
    const double slack = 1e-6 + 1e-14 * last();  // rounding of place(), in entries
    const double from = std::ceil(std::max(place(polar_of_turn(turn_from)), range.from) - slack);
    const double to = std::floor(std::min(place(polar_of_turn(turn_to)), range.to) + slack);
    if (from > to) return;
    const std::size_t end = static_cast<std::size_t>(std::min(to, last())) + 1;
    const std::size_t first = std::max(range.next, static_cast<std::size_t>(std::max(from, 0.0)));
    range.next = std::max(first, end);
    if constexpr (requires(DirectionRun run) { placement_.fill(run); }) {
      DirectionRun run;
      for (run.first = first; run.first < end; run.first += run.count) {
        run.count = std::min(end - run.first, DirectionRun::kMost);
        placement_.fill(run);
        visit(static_cast<const DirectionRun&>(run));
      }
    } else if (first < end) {
      const auto direction_of = [&](std::size_t k) { return direction(first + k); };
      visit_in_runs(first, end - first, direction_of, visit);
    }
  }

  P placement_;
  double covering_radius_ = kPi;
  double stencil_radius_ = kPi;
};

}  // namespace impinge
