// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolated minus true radius, by hand.
#include "curves/lookup_error.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/scheme.hpp"

namespace impinge {
namespace {

TEST(LookupError, IsThatOfTwoKnownDirections) {
  const std::vector<double> radii{10.0, 14.0};
  const auto stencil = [](const Vec3& u) {
    return u.z() > 0.0 ? Stencil{{0, 1, 0, 0}, {0.75, 0.25, 0.0, 0.0}, 2, 0}
                       : Stencil{{1, 0, 0, 0}, {1.0}, 1, 0};
  };
  const std::vector<Vec3> directions{{0, 0, 1}, {0, 0, -1}};
  const LookupError error = lookup_error(
      radii, stencil, [](const Vec3&) { return 10.0; }, directions);
  EXPECT_DOUBLE_EQ(error.largest, 4.0);
  EXPECT_DOUBLE_EQ(error.root_mean_square, std::sqrt((1.0 + 16.0) / 2.0));
}

}  // namespace
}  // namespace impinge
