// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials by Estrin's scheme: about as many products as by Horner's, but half of them do not wait for
// each other. Included once for each instruction set, hence no #pragma once.
#if defined(IMPINGE_POLYNOMIAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef IMPINGE_POLYNOMIAL_INL
#undef IMPINGE_POLYNOMIAL_INL
#else
#define IMPINGE_POLYNOMIAL_INL
#endif

#include <array>
#include <bit>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace impinge::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// x, x^2, x^4, x^8.
template <class D>
struct Powers {
  hn::Vec<D> power[4];
};

// sum of terms[kFrom + k] x^k over kCount terms, at most 16.
template <std::size_t kFrom, std::size_t kCount, class D, class Terms>
HWY_INLINE hn::Vec<D> polynomial_part(D d, const Terms& terms, const Powers<D>& of) {
  if constexpr (kCount == 1) {
    return hn::Set(d, terms[kFrom]);
  } else {
    constexpr std::size_t kHalf = std::bit_floor(kCount - 1);
    const auto low = polynomial_part<kFrom, kHalf>(d, terms, of);
    const auto high = polynomial_part<kFrom + kHalf, kCount - kHalf>(d, terms, of);
    return hn::Add(low, hn::Mul(high, of.power[std::countr_zero(kHalf)]));
  }
}

template <class D, std::size_t kCount>
HWY_INLINE hn::Vec<D> polynomial(D d, const std::array<hn::TFromD<D>, kCount>& terms, hn::Vec<D> x) {
  const auto x2 = hn::Mul(x, x);
  const auto x4 = hn::Mul(x2, x2);
  return polynomial_part<0, kCount>(d, terms, Powers<D>{{x, x2, x4, hn::Mul(x4, x4)}});
}

}  // namespace impinge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
