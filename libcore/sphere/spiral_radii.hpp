// SPDX-License-Identifier: GPL-3.0-or-later
// Covering radius and stencil radius of a Spiral; see sphere/spiral.hpp for what a placement is. Radians.
//
// The first 64 entries at either pole, where turns are strongly curved, are treated one by one. Between these
// caps two numbers describe the curve at a polar angle: the spacing A of its turns and the step D between
// entries. Both are monotone between the samples that are taken of them, so that what grows with both is
// nowhere above the larger of two samples by more than the ratio of the samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sphere/direction.hpp"
#include "sphere/largest_gap.hpp"

namespace impinge {

/// Entries that are treated one by one at each pole.
inline constexpr double kPolarEntries = 64.0;

/// A placement seen from one of its poles: angles, turns and places are counted from there.
template <class P>
class FromPole {
 public:
  /// Keeps a reference to the placement. It is seen from the south pole if `south`, else from the north pole.
  FromPole(const P& placement, bool south) : placement_(placement), south_(south) {}

  double last() const { return placement_.last(); }
  double turn(double phi) const {
    return south_ ? placement_.turns() - placement_.turn(kPi - phi) : placement_.turn(phi);
  }
  double polar_of_turn(double turn) const {
    const double known = std::clamp(south_ ? placement_.turns() - turn : turn, 0.0, placement_.turns());
    return south_ ? kPi - placement_.polar_of_turn(known) : placement_.polar_of_turn(known);
  }
  double place(double phi) const {
    return south_ ? placement_.last() - placement_.place(kPi - phi) : placement_.place(phi);
  }
  double polar_angle(double t) const {
    const double known = std::clamp(south_ ? last() - t : t, 0.0, last());
    return south_ ? kPi - placement_.polar_angle(known) : placement_.polar_angle(known);
  }
  /// The direction of an entry with the pole at +z, mirrored for the south pole, which keeps distances.
  Vec3 direction(std::size_t entry) const {
    const Vec3 u = placement_.direction(south_ ? static_cast<std::size_t>(last()) - entry : entry);
    return {u.x(), u.y(), south_ ? -u.z() : u.z()};
  }
  /// Polar angle of the turn below the one that passes phi.
  double below(double phi) const { return polar_of_turn(turn(phi) + 1.0); }

 private:
  const P& placement_;
  bool south_;
};

/// Upper bound on f(phi) between two polar angles, f positive and monotone between samples.
template <class F>
double largest_between(double low, double high, const F& f, int depth = 0) {
  constexpr int kLeast = 4;
  constexpr int kMost = 14;
  const double at_low = f(low);
  const double at_high = f(high);
  const double larger = std::max(at_low, at_high);
  const double ratio = larger / std::min(at_low, at_high);
  if ((depth >= kLeast && ratio < 1.005) || depth == kMost) return larger * ratio;
  const double middle = 0.5 * (low + high);
  return std::max(largest_between(low, middle, f, depth + 1), largest_between(middle, high, f, depth + 1));
}

/// Half the diagonal of A by D: the covering radius if the sphere were flat.
template <class P>
double flat_gap(const FromPole<P>& curve, double phi) {
  const double t = curve.place(phi);
  const double before = curve.polar_angle(t - 0.5);
  const double after = curve.polar_angle(t + 0.5);
  const double across = 2.0 * kPi * std::sin(phi) * (curve.turn(after) - curve.turn(before));
  return 0.5 * std::hypot(curve.below(phi) - phi, std::hypot(after - before, across));
}

/// Largest distance of a direction at phi from the nearer of two entries, one step apart, on the turn that
/// passes its azimuth at phi_turn.
template <class P>
double worst_on_turn(const FromPole<P>& curve, double phi, double phi_turn) {
  const double turn = curve.turn(phi_turn);
  const auto away = [&](double t) {
    const double entry = curve.polar_angle(t);
    return separation(phi, entry, 2.0 * kPi * (turn - curve.turn(entry)));
  };
  const double t = curve.place(phi_turn);
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < 50; ++k) {
    const double back = 0.5 * (low + high);
    (away(t - back) < away(t - back + 1.0) ? low : high) = back;
  }
  return away(t - high);
}

/// Largest distance to the nearest entry from a direction between the turn through phi_a and the one below,
/// if the entries on both are as far away as they can be. Halving finds the direction that is equally far
/// from both.
template <class P>
double worst_gap(const FromPole<P>& curve, double phi_a) {
  const double phi_b = curve.below(phi_a);
  double low = phi_a;
  double high = phi_b;
  for (int k = 0; k < 50; ++k) {
    const double phi = 0.5 * (low + high);
    (worst_on_turn(curve, phi, phi_a) < worst_on_turn(curve, phi, phi_b) ? low : high) = phi;
  }
  return worst_on_turn(curve, high, phi_a);
}

/// The largest sine between two polar angles.
inline double widest_parallel(double from, double to) {
  return from < 0.5 * kPi && to > 0.5 * kPi ? 1.0 : std::max(std::sin(from), std::sin(to));
}

/// Upper bound on the length of the curve between two polar angles: each piece counts as if on its longest
/// parallel.
template <class P>
double curve_length(const FromPole<P>& curve, double from, double to) {
  constexpr int kPieces = 16;
  double length = 0.0;
  double phi = from;
  for (int k = 1; k <= kPieces; ++k) {
    const double next = from + (to - from) * k / kPieces;
    const double across = 2.0 * kPi * (curve.turn(next) - curve.turn(phi));
    length += std::hypot(next - phi, across * widest_parallel(phi, next));
    phi = next;
  }
  return length;
}

/// Upper bound on the gap at the polar entries. From any direction between two turns the nearer one is at
/// most half of their distance away, and an entry at most half a step along it. The pole stands for a missing
/// turn.
template <class P>
double polar_gap_bound(const FromPole<P>& curve) {
  double largest = 0.5 * curve.polar_of_turn(1.0);
  for (double i = 0.0; i < std::min(kPolarEntries, curve.last()); i += 1.0) {
    const double phi = curve.polar_angle(i);
    const double next = curve.polar_angle(i + 1.0);
    const double above = curve.polar_of_turn(curve.turn(phi) - 1.0);
    const double spacing = std::max(curve.below(next) - next, phi - above);
    largest = std::max(largest, 0.5 * (spacing + curve_length(curve, phi, next)));
  }
  return std::min(largest, kPi);
}

/// The largest gap in the cap at the pole, exact unless too many entries are in reach; then
/// polar_gap_bound(). (Too many are where the cap of a conchoid that is nearly a cusp takes in half of the
/// sphere.)
template <class P>
double polar_gap(const FromPole<P>& curve) {
  constexpr double kMostTaken = 2000.0;
  const double cap = curve.polar_angle(std::min(kPolarEntries, curve.last()));
  const double reach = 1.5 * std::max(worst_gap(curve, curve.polar_of_turn(0.5 * curve.turn(kPi) - 0.5)),
                                      flat_gap(curve, curve.polar_angle(1.0)));
  const double taken = std::min(std::floor(curve.place(std::min(cap + 2.0 * reach, kPi))), curve.last());
  if (taken > kMostTaken) return polar_gap_bound(curve);
  std::vector<Vec3> polar;
  for (double i = 0.0; i <= taken; i += 1.0) polar.push_back(curve.direction(static_cast<std::size_t>(i)));
  return largest_gap(polar, std::cos(cap), reach);
}

/// The covering radius: the larger of the gap at the poles and the gap elsewhere, where entries of
/// neighbouring turns may be in any phase to each other. There the gap exceeds the flat one because parallels
/// are curved, the most at the edge of the polar cap.
template <class P>
double spiral_covering_radius(const P& placement) {
  double gap = 0.0;
  double curved = 1.0;
  for (const bool south : {false, true}) {
    if (south && P::kMirrored) continue;
    const FromPole<P> curve(placement, south);
    gap = std::max(gap, polar_gap(curve));
    if (curve.last() <= 2.0 * kPolarEntries) continue;
    const double cap = curve.polar_of_turn(curve.turn(curve.polar_angle(kPolarEntries)) - 1.0);
    curved = std::max(curved, worst_gap(curve, cap) / flat_gap(curve, cap));
  }
  if (placement.last() > 2.0 * kPolarEntries) {
    const FromPole<P> curve(placement, false);
    const double from = curve.polar_of_turn(curve.turn(curve.polar_angle(kPolarEntries)) - 1.0);
    const double to = curve.polar_angle(curve.last() - kPolarEntries);
    const double flat = largest_between(from, to, [&](double phi) { return flat_gap(curve, phi); });
    gap = std::max(gap, curved * flat);
  }
  return gap * (1.0 + 1e-9);
}

/// Length of a way from entry i to the far corner of its ribbon (one turn below the next entry) that does not
/// leave the ribbon: along the turn while the pole is in the way, then straight. Near a pole this is longer
/// than the way across it.
template <class P>
double way_to_far_corner(const FromPole<P>& curve, double i) {
  const double phi = curve.polar_angle(i);
  const double next = curve.polar_angle(i + 1.0);
  const double corner = curve.below(next);
  for (int part = 0;; ++part) {
    const double from = phi + (next - phi) * part / 16.0;
    const double apart = 2.0 * kPi * (curve.turn(next) - curve.turn(from));
    const double sin_from = std::sin(from);
    const double down = std::cos(from) * std::sin(corner) * std::cos(apart) - sin_from * std::cos(corner);
    const double ahead = std::sin(corner) * std::sin(apart);
    if (part < 16 && i > 0.0 && down * apart * sin_from < ahead * (next - from)) continue;
    const double along = 2.0 * kPi * sin_from * (curve.turn(from) - curve.turn(phi));
    return std::hypot(from - phi, along) + separation(from, corner, apart);
  }
}

/// Upper bound on the way from the entry at place t to a direction that reads it, on any placement: along the
/// turn to the azimuth of the direction, at most the longer step next to the entry, then along the meridian,
/// at most a spacing of turns; or both at once, along phi and across on the longest parallel that is met.
template <class P>
double way_to_readers(const FromPole<P>& curve, double t) {
  const double phi = curve.polar_angle(t);
  const double before = curve.polar_angle(t - 1.0);
  const double after = curve.polar_angle(t + 1.0);
  const double above = curve.polar_of_turn(curve.turn(before) - 1.0);
  const double below = curve.below(after);
  const double step = std::max(curve_length(curve, before, phi), curve_length(curve, phi, after));
  const double spacing = std::max(below - after, before - above);
  const double turn = curve.turn(phi);
  const double across = 2.0 * kPi * std::max(curve.turn(after) - turn, turn - curve.turn(before));
  const double along = std::max(below - phi, phi - above);
  return std::min(step + spacing, std::hypot(along, across * widest_parallel(above, below)));
}

/// The stencil radius. The direction farthest from an entry is at the far corner of its ribbon if turns are
/// no farther apart at the pole than elsewhere, as on a helix. Beyond the polar entries a direction that
/// reads an entry is at most a step and a spacing away along phi, and across at most the azimuth of the step
/// on the longest parallel that is met.
template <class P>
double spiral_stencil_radius(const P& placement) {
  if (placement.turns() < 2.5) return kPi;  // six entries or so: some stencils span the sphere
  double largest = 0.0;
  for (const bool south : {false, true}) {
    if (south && P::kMirrored) continue;
    const FromPole<P> curve(placement, south);
    largest = std::max(largest, curve.polar_of_turn(1.0));
    for (double i = 0.0; i < std::min(kPolarEntries, curve.last()); i += 1.0)
      largest = std::max(largest, P::kMirrored ? way_to_far_corner(curve, i) : way_to_readers(curve, i));
  }
  if (placement.last() > 2.0 * kPolarEntries) {
    const FromPole<P> curve(placement, false);
    const double from = curve.polar_angle(kPolarEntries);
    const double to = curve.polar_angle(curve.last() - kPolarEntries);
    const auto way = [&](double phi) { return way_to_readers(curve, curve.place(phi)); };
    largest = std::max(largest, largest_between(from, to, way));
  }
  return std::min(largest, kPi);
}

/// For the placements of the library these functions are compiled once, in the file of each.
class ArcSteps;
class ConchoidSteps;
class HeightSteps;
extern template double spiral_covering_radius(const ArcSteps&);
extern template double spiral_covering_radius(const ConchoidSteps&);
extern template double spiral_covering_radius(const HeightSteps&);
extern template double spiral_stencil_radius(const ArcSteps&);
extern template double spiral_stencil_radius(const ConchoidSteps&);
extern template double spiral_stencil_radius(const HeightSteps&);

}  // namespace impinge
