// SPDX-License-Identifier: GPL-3.0-or-later
// phi_i = arccos(i dT / r) (thesis, Section 3.5.2)
#include "spectrum/slices.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sphere/direction.hpp"

namespace impinge {
namespace {

TEST(Slices, OfTheThesis) {
  const auto slices = slices_of_sphere(22.0, 1.25);
  ASSERT_EQ(slices.size(), 18U);  // the middle one and 17 above it
  EXPECT_DOUBLE_EQ(slices[0].phi, kPi / 2.0);
  EXPECT_EQ(slices[0].gap, 0.0);
  EXPECT_NEAR(slices[1].gap / kDegree, 3.2572, 1e-4);
  for (std::size_t i = 1; i < slices.size(); ++i) {
    EXPECT_NEAR(22.0 * std::cos(slices[i].phi), 1.25 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(slices[i].gap, slices[i - 1].phi - slices[i].phi, 1e-15);
    if (i > 1) {
      EXPECT_GT(slices[i].gap, slices[i - 1].gap);
    }
  }
}

TEST(Slices, TheLastOneMayTouchThePole) {
  const auto slices = slices_of_sphere(1.0, 0.1);  // 10 * 0.1 is meant to be 1
  ASSERT_EQ(slices.size(), 11U);
  EXPECT_EQ(slices.back().phi, 0.0);
  EXPECT_EQ(slices_of_sphere(5.0, 5.0).size(), 2U);
}

TEST(Slices, RefusesSizesThatMakeNoSense) {
  for (const double thickness : {0.0, -1.0, 30.0, std::nan("")})
    EXPECT_THROW(slices_of_sphere(22.0, thickness), std::invalid_argument);
  EXPECT_THROW(slices_of_sphere(std::numeric_limits<double>::infinity(), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace impinge
