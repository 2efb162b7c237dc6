// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the place of a point on the helix of USID, and the number that is stored there; see sphere/spiral.hpp
// for the stencil and sphere/height_steps.hpp for the helix. It works in double, as a place is a number of up
// to 2^28 entries and a fraction. Included once for each instruction set, hence no #pragma once.
#if defined(IMPINGE_HELIX_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_HELIX_INL
#undef IMPINGE_HELIX_INL
#else
#define IMPINGE_HELIX_INL
#endif

#include <array>

#include <hwy/highway.h>

#include "gap/simd/angle-inl.hpp"
#include "gap/simd/helix_pairs-inl.hpp"
#include "gap/simd/scan-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {

// The polynomial of sphere/haversine.hpp.
inline constexpr std::array<double, 9> kHaversine{0.25,
                                                  -0.020833333333333332,
                                                  0.0006944444444444408,
                                                  -1.2400793650778323e-05,
                                                  1.3778659608796522e-07,
                                                  -1.0438378119385112e-09,
                                                  5.735347005437413e-12,
                                                  -2.388702444845624e-14,
                                                  7.584583483408685e-17};

// hav(angle) = (1 - cos angle) / 2, for an angle in [0, pi].
template <class D>
HWY_INLINE hn::Vec<D> haversine_lanes(D d, hn::Vec<D> angle) {
  const auto obtuse = hn::Gt(angle, hn::Set(d, 0.5 * kPi));
  const auto x = hn::IfThenElse(obtuse, hn::Sub(hn::Set(d, kPi), angle), angle);
  const auto y = hn::Mul(x, x);
  const auto share = hn::Mul(y, polynomial(d, kHaversine, y));
  return hn::IfThenElse(obtuse, hn::Sub(hn::Set(d, 1.0), share), share);
}

// The places above and below a point on the two turns, and how far down between them it is.
template <class D>
struct HelixPlace {
  Line<D> above;
  Line<D> below;
  hn::Vec<D> down;
  hn::Vec<D> cell;
};

class HelixLanes {
 public:
  template <class Value>
  explicit HelixLanes(const PackedTable<Usid, Value>& table)
      : turns_(static_cast<double>(table.divisions)), last_(turns_ * turns_ - 1.0) {}

  // A pole stands for the turn that is missing above the first one and below the last one.
  template <class D>
  HWY_INLINE HelixPlace<D> place(D d, const Point<D>& p) const {
    const auto zero = hn::Zero(d);
    const auto one = hn::Set(d, 1.0);
    const auto turns = hn::Set(d, turns_);
    const auto across = hn::Sqrt(hn::Add(hn::Mul(p.x, p.x), hn::Mul(p.y, p.y)));
    const auto half = hn::Mul(half_turn_angle(d, p.y, p.x), hn::Set(d, 0.5 / kPi));
    const auto azimuth = hn::IfThenElse(hn::Lt(p.y, zero), hn::Sub(one, half), half);
    const auto turn = hn::Mul(half_turn_angle(d, across, p.z), hn::Set(d, turns_ / kPi));
    const auto whole = hn::Floor(hn::Sub(turn, azimuth));
    const auto here = hn::Add(whole, azimuth);  // turns of the helix above the point, at its azimuth
    const auto next = hn::Add(here, one);
    const auto turn_a = hn::Max(here, zero);
    const auto turn_b = hn::Min(next, turns);
    auto down = hn::Sub(turn, turn_a);
    const auto polar = hn::Or(hn::Lt(here, zero), hn::Gt(next, turns));
    if (!hn::AllFalse(d, polar)) {
      const auto apart = hn::Sub(turn_b, turn_a);
      const auto divided = hn::Div(down, hn::IfThenElse(hn::Gt(apart, zero), apart, one));
      down = hn::IfThenElse(polar, divided, down);
    }
    down = hn::Min(hn::Max(down, zero), one);
    const Line<D> above = on_turn(d, turn_a);
    const Line<D> below = on_turn(d, turn_b);
    const auto a_after = hn::IfThenElseZero(hn::Ge(whole, zero), hn::Add(above.below, one));
    const auto b = hn::IfThenElse(hn::Gt(next, turns), hn::Set(d, last_), below.below);
    return {above, below, down, hn::Add(a_after, b)};
  }

  template <class D>
  HWY_INLINE hn::Vec<D> gap(D d, const Point<D>& p, const HelixPlace<D>& /*place*/, hn::Vec<D> r) const {
    return radial_gap(d, p, r);
  }

 private:
  // The entries between which the helix is after so many turns.
  template <class D>
  HWY_INLINE Line<D> on_turn(D d, hn::Vec<D> turn) const {
    const auto phi = hn::Min(hn::Mul(turn, hn::Set(d, kPi / turns_)), hn::Set(d, kPi));
    const auto last = hn::Set(d, last_);
    return line_below(d, hn::Mul(last, haversine_lanes(d, phi)), last);
  }

  double turns_;
  double last_;  // place of the south pole
};

template <class D, class Table>
HWY_INLINE Found<D> look_up(D d, const Table& table, const HelixPlace<D>& place) {
  const Whole<D> whole;
  const Pair<D> a = helix_pair(d, table.values, hn::ConvertTo(whole, place.above.below));
  const Pair<D> b = helix_pair(d, table.values, hn::ConvertTo(whole, place.below.below));
  const auto above = hn::Add(a.left, hn::Mul(place.above.share, hn::Sub(a.right, a.left)));
  const auto below = hn::Add(b.left, hn::Mul(place.below.share, hn::Sub(b.right, b.left)));
  const auto stored = hn::Add(above, hn::Mul(place.down, hn::Sub(below, above)));
  auto none = hn::Ne(stored, stored);
  if (table.none != nullptr) none = hn::Or(none, has_none(d, table.none, hn::ConvertTo(whole, place.cell)));
  return {decoded(d, table, stored), none};
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
