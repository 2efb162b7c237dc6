// SPDX-License-Identifier: GPL-3.0-or-later
// The rings of a scheme hold its entries in their order, and are where ring_position() says.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "sphere/scheme.hpp"

namespace impinge::test {

template <SamplingScheme S>
void expect_rings_in_order(const S& scheme) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < scheme.rings(); ++k) {
    const Ring ring = scheme.ring(k);
    EXPECT_EQ(ring.first, next);
    EXPECT_NEAR(scheme.ring_position(std::atan2(ring.polar.sin, ring.polar.cos)), static_cast<double>(k),
                1e-12);
    for (std::size_t t = 0; t < ring.count; ++t) EXPECT_EQ(scheme.direction(next + t), ring.direction(t));
    next += ring.count;
  }
  EXPECT_EQ(next, scheme.size());
}

}  // namespace impinge::test
