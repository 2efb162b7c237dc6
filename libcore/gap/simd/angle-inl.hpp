// SPDX-License-Identifier: GPL-3.0-or-later
// The angle of a point of the plane, without libm. Included once for each instruction set, hence no #pragma
// once.
#if defined(IMPINGE_ANGLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_ANGLE_INL
#undef IMPINGE_ANGLE_INL
#else
#define IMPINGE_ANGLE_INL
#endif

#include <array>
#include <numbers>

#include <hwy/highway.h>

#include "gap/simd/polynomial-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// atan(t) = t + t s P(s), s = t^2, for |t| <= tan(pi / 8). P has the least possible error relative to t
// (Remez): 6.6e-10 with five terms, 3.4e-17 with ten.
inline constexpr std::array<float, 5> kFloatArctangent{-0.333333154975439653F, 0.199984889195458961F,
                                                       -0.142438381810787797F, 0.10595918081792555F,
                                                       -0.0608322917027841724F};
inline constexpr std::array<double, 10> kDoubleArctangent{
    -0.333333333333302156,  0.199999999991040398,  -0.142857141964710885,  0.111111067011586552,
    -0.0909078347057694192, 0.0769008251269590193, -0.0664123876781760967, 0.0569312496737702673,
    -0.0436070863893171581, 0.0212786949072950967};

template <class T>
constexpr const auto& arctangent_terms() {
  if constexpr (sizeof(T) == 4) {
    return kFloatArctangent;
  } else {
    return kDoubleArctangent;
  }
}

template <class D>
HWY_INLINE hn::Vec<D> small_arctangent(D d, hn::Vec<D> t) {
  const auto s = hn::Mul(t, t);
  const auto sum = polynomial(d, arctangent_terms<hn::TFromD<D>>(), s);
  return hn::Add(t, hn::Mul(hn::Mul(t, s), sum));
}

// atan2(|y|, x) in [0, pi]; 0 for (0, 0). With l the lesser and u the larger of |x|, |y|, and l / u above
// tan(pi / 8), atan(l / u) = pi / 4 + atan((l - u) / (l + u)).
template <class D>
HWY_INLINE hn::Vec<D> half_turn_angle(D d, hn::Vec<D> y, hn::Vec<D> x) {
  using T = hn::TFromD<D>;
  constexpr T kQuarter = std::numbers::pi_v<T> / 4;
  const auto height = hn::Abs(y);
  const auto width = hn::Abs(x);
  const auto lower = hn::Min(height, width);
  const auto upper = hn::Max(height, width);
  const auto steep = hn::Gt(lower, hn::Mul(upper, hn::Set(d, static_cast<T>(std::numbers::sqrt2 - 1.0))));
  const auto over = hn::IfThenElse(steep, hn::Sub(lower, upper), lower);
  const auto under = hn::IfThenElse(steep, hn::Add(lower, upper), upper);
  const auto safe = hn::IfThenElse(hn::Gt(under, hn::Zero(d)), under, hn::Set(d, T{1}));
  auto angle =
      hn::Add(hn::IfThenElseZero(steep, hn::Set(d, kQuarter)), small_arctangent(d, hn::Div(over, safe)));
  angle = hn::IfThenElse(hn::Gt(height, width), hn::Sub(hn::Set(d, 2 * kQuarter), angle), angle);
  return hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 4 * kQuarter), angle), angle);
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
