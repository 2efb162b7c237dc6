// SPDX-License-Identifier: GPL-3.0-or-later
// The mean of the taps of a stencil, whatever the entries hold.
#pragma once

#include <cstddef>

#include "sphere/scheme.hpp"

namespace impinge {

/// sum w_k values[entry_k]. A tap of weight zero does not count: on an entry the entry alone decides, whether
/// or not there is surface beside it.
template <class Values>
double interpolate(const Stencil& stencil, const Values& values) {
  double sum = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    if (stencil.weight[k] > 0.0) sum += stencil.weight[k] * values[stencil.entry[k]];
  }
  return sum;
}

}  // namespace impinge
