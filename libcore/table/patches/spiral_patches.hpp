// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of spirals: s is the azimuth in turns, t the share of the way from the turn above to the turn
// below; `part` is 1 + the number of whole turns above.
//
// Let polar(x) be the polar angle at turn x, with the derivatives P' and P''. The direction u has
// phi = polar(x), theta = 2 pi s with x = a + t (b - a), where a = part - 1 + s is the turn above or the
// north pole, and b the turn below or the south pole. As a and b rise with s by 1 or 0, and b - a <= 1, along
// t
//   way <= P',  turn <= |P''|,
// and along s
//   way <= hypot(P', 2 pi sin(phi)),
//   turn <= hypot(|P''| + 4 pi^2 sin(phi) |cos(phi)|, 4 pi P' |cos(phi)|).
// Along a turn weights are linear in the place among the entries, q(x) = place(polar(x)), and not in s: sum
// |w''| / 2 <= max |q''|.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sphere/arc_steps.hpp"
#include "sphere/conchoid_steps.hpp"
#include "sphere/height_steps.hpp"
#include "sphere/spiral.hpp"
#include "table/patches/angle_patches.hpp"
#include "table/patches/patch.hpp"

namespace impinge {

/// Upper bounds on P', |P''| and |q''| of a placement between two polar angles.
struct TurnRates {
  double polar;       // P', radians a turn
  double polar_bend;  // |P''|
  double place_bend;  // |q''|, entries
};

/// Largest |cos(phi)|.
inline double largest_cosine(double from, double to) {
  return std::max(std::abs(std::cos(from)), std::abs(std::cos(to)));
}

/// q = (w - 1) (1 - cos(h x)) / 2 with h the distance of turns.
inline TurnRates turn_rates(const HeightSteps& steps, double from, double to) {
  const double h = kPi / steps.turns();
  return {h, 0.0, 0.5 * steps.last() * h * h * largest_cosine(from, to)};
}

/// q' = h sqrt(1 + 4 k^2 sin^2(phi)) (w - 1) / L with k turns, so that
///   q'' = h^2 4 k^2 sin cos / sqrt(..) (w - 1) / L <= 2 k h^2 |cos| (w - 1) / L.
inline TurnRates turn_rates(const ArcSteps& steps, double from, double to) {
  const double h = kPi / steps.turns();
  return {h, 0.0, 2.0 * steps.turns() * h * h * largest_cosine(from, to) * steps.last() / steps.length()};
}

/// With r = 1 + b cos(phi) and the meridian's length ds = m dphi, m^2 = 1 + b^2 + 2 b cos(phi):
///   P' = h / m,  P'' = h^2 b sin(phi) / m^4,
///   q' = 2 pi h r sin(phi) / A1,  q'' = 2 pi h (r cos(phi) - b sin^2(phi)) P' / A1,  A1 the area of a step.
inline TurnRates turn_rates(const ConchoidSteps& steps, double from, double to) {
  const double b = steps.ratio();
  const double h = steps.spacing();
  const double m2 = 1.0 + b * b + 2.0 * b * std::cos(to);  // falls with phi
  const double sine = largest_sine(from, to);
  const double polar = h / std::sqrt(m2);
  const double bend = (1.0 + b * std::cos(from)) * largest_cosine(from, to) + b * sine * sine;
  return {polar, h * h * b * sine / (m2 * m2), 2.0 * kPi * h * bend * polar / steps.step_area()};
}

template <class P>
class SpiralPatches {
 public:
  explicit SpiralPatches(const P& placement) : placement_(placement) {}  // takes a copy of the placement

  template <class Visit>
  void for_each(Visit&& visit) const {
    const auto entries = static_cast<std::size_t>(placement_.last()) + 1;
    std::vector<double> turn(entries);
    for (std::size_t i = 0; i < entries; ++i)
      turn[i] = placement_.turn(placement_.polar_angle(static_cast<double>(i)));
    std::size_t first = 0;  // the first entry that may divide the turn above
    for (std::size_t part = 0; static_cast<double>(part) - 1.0 < placement_.turns(); ++part) {
      const double above = static_cast<double>(part) - 1.0;
      while (first < entries && turn[first] < above) ++first;
      visit_turn(part, turn, first, visit);
    }
  }

  Vec3 at(const Patch& patch, double s, double t) const {
    return to_direction({polar(turn_at(patch, s, t)), 2.0 * kPi * s});
  }

  PatchMotion motion(const Patch& patch, const Rect& rect) const {
    const double from = polar(turn_at(patch, rect.from[0], rect.from[1]));
    const double to = polar(turn_at(patch, rect.to[0], rect.to[1]));
    const double top = polar(turn_at(patch, rect.from[0], 0.0));
    const double bottom = polar(turn_at(patch, rect.to[0], 1.0));
    const TurnRates rates = turn_rates(placement_, top, bottom);
    const double sine = largest_sine(from, to);
    const double cosine = largest_cosine(from, to);
    const double ds = rect.width(0);
    const double dt = rect.width(1);
    PatchMotion motion;
    motion.way = {ds * std::hypot(rates.polar, 2.0 * kPi * sine), dt * rates.polar};
    motion.turn = {
        ds * ds *
            std::hypot(rates.polar_bend + 4.0 * kPi * kPi * sine * cosine, 4.0 * kPi * rates.polar * cosine),
        dt * dt * rates.polar_bend};
    motion.bend = {ds * ds * rates.place_bend, 0.0};
    return motion;
  }

 private:
  double polar(double turn) const {
    return std::clamp(placement_.polar_of_turn(std::clamp(turn, 0.0, placement_.turns())), 0.0, kPi);
  }
  double turn_at(const Patch& patch, double s, double t) const {
    const double above = static_cast<double>(patch.part) - 1.0 + s;
    const double a = std::max(above, 0.0);
    const double b = std::min(above + 1.0, placement_.turns());
    return a + t * std::max(b - a, 0.0);
  }

  /// Visits the patches between two turns, divided at the azimuths of the entries of both.
  template <class Visit>
  void visit_turn(std::size_t part, const std::vector<double>& turn, std::size_t first, Visit&& visit) const {
    const double above = static_cast<double>(part) - 1.0;
    const double end = std::min(1.0, placement_.turns() - above);
    std::vector<double> lines{0.0, end};
    const auto add = [&](double s) {
      if (s > 0.0 && s < end) lines.push_back(s);
    };
    for (std::size_t i = first; i < turn.size() && turn[i] < above + 2.0; ++i) {
      add(turn[i] - above);
      add(turn[i] - above - 1.0);
    }
    add(placement_.turns() - above - 1.0);  // where the south pole begins to be below
    std::ranges::sort(lines);
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
      if (lines[k + 1] > lines[k]) visit(Patch{part, {{lines[k], 0.0}, {lines[k + 1], 1.0}}});
    }
  }

  P placement_;
};

template <class P>
SpiralPatches<P> patches_of(const Spiral<P>& scheme) {
  return SpiralPatches<P>(scheme.placement());
}

}  // namespace impinge
