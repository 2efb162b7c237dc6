// SPDX-License-Identifier: GPL-3.0-or-later
// The weighted mean of the values at the taps of a stencil.
#pragma once

#include <cstddef>

#include "sphere/scheme.hpp"

namespace impinge {

/// sum w_k values[entry_k]. A tap of weight zero does not count, so that at an entry its own value is the
/// answer, whether or not there is surface beside it.
template <class Values>
double interpolate(const Stencil& stencil, const Values& values) {
  double sum = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    if (stencil.weight[k] > 0.0) sum += stencil.weight[k] * values[stencil.entry[k]];
  }
  return sum;
}

}  // namespace impinge
