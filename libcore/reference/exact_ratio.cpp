// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact_ratio.hpp"

#include <cmath>
#include <cstdint>

#include <gmpxx.h>

namespace impinge {
namespace {

long bits(const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

mpz_class times_power_of_two(const mpz_class& x, long exponent) {
  return exponent > 0 ? mpz_class(x << static_cast<mp_bitcnt_t>(exponent)) : x;
}

}  // namespace

// root(A / B 2^e) = root(A 2^s / B) 2^((e - s) / 2). With A 2^s / B between 2^125 and 2^128 the integer root
// has 63 or 64 bits. Its last bit is set if anything was cut off. As a double has 53 bits, this decides every
// tie as the whole root would.
double nearest_root(const ExactRatio& ratio) {
  if (ratio.over.is_zero()) return 0.0;
  const mpz_class over(ratio.over.man());
  const mpz_class under(ratio.under.man());
  const long exponent = ratio.over.exp() - ratio.under.exp();
  long shift = 127 - (bits(over) - bits(under));
  if ((exponent - shift) % 2 != 0) --shift;
  const mpz_class numerator = times_power_of_two(over, shift);
  const mpz_class denominator = times_power_of_two(under, -shift);
  const mpz_class quotient = numerator / denominator;
  const mpz_class root = sqrt(quotient);
  std::uint64_t digits = root.get_ui();
  if (root * root * denominator != numerator) digits |= 1U;
  return std::ldexp(static_cast<double>(digits), static_cast<int>((exponent - shift) / 2));
}

}  // namespace impinge
