// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. 14-16 of the thesis and the exact angles: each cuts what it should into equal parts.
#include "curves/conchoid_rays.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sphere/direction.hpp"

namespace impinge {
namespace {

TEST(ConchoidRays, OriginalOnesAreEquallyFarApart) {
  const auto phi = original_angles(4);
  ASSERT_EQ(phi.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(phi[i], 30.0 * static_cast<double>(i) * kDegree);
  EXPECT_EQ(original_angles(901).back(), 0.5 * kPi);
}

// Eq. 16 for 91 rays: phi_i = 2 asin(0.00785 i), whose last digit is rounded.
TEST(ConchoidRays, ThesisFormIsEq16) {
  const auto phi = adjusted_angles(thesis_closed_form(), 91);
  for (std::size_t i = 0; i < 91; ++i) {
    EXPECT_NEAR(std::sin(0.5 * phi[i]), 0.00785 * static_cast<double>(i), 5e-6 * static_cast<double>(i));
  }
}

// The closed form cuts its own length equally: p(phi_i) = i p(90 degrees) / (n - 1), for any shape.
TEST(ConchoidRays, ClosedFormCutsItsOwnLengthEqually) {
  for (const ConchoidShape& shape : {ConchoidShape{}, {22.0, 1.0}, {20.0, 20.0}}) {
    const auto phi = adjusted_angles(closed_form(shape), 31);
    for (std::size_t i = 0; i < 31; ++i) {
      EXPECT_NEAR(closed_form_length(shape, phi[i]),
                  static_cast<double>(i) / 30.0 * closed_form_length(shape, 0.5 * kPi), 1e-12);
    }
    EXPECT_DOUBLE_EQ(phi.back(), 0.5 * kPi);
  }
}

// The thesis' 4.29 and 3.03 are the form of a = 1.15 b, rounded.
TEST(ConchoidRays, ThesisFormIsTheRoundedOne) {
  const ConchoidClosedForm form = closed_form({1.15, 1.0});
  EXPECT_NEAR(form.factor, thesis_closed_form().factor, 5e-3);
  EXPECT_NEAR(form.quarter, thesis_closed_form().quarter, 5e-3);
}

// At the cusp the closed form is no approximation: a^2 + b^2 is 2 a b.
TEST(ConchoidRays, ClosedFormIsExactAtTheCusp) {
  const ConchoidShape cusp{20.0, 20.0};
  const auto closed = adjusted_angles(closed_form(cusp), 19);
  const auto exact = equal_arc_angles(cusp, 19);
  for (std::size_t i = 0; i < 19; ++i) EXPECT_NEAR(closed[i], exact[i], 1e-14);
}

TEST(ConchoidRays, ExactOnesCutTheArcEqually) {
  for (const ConchoidShape& shape : {ConchoidShape{}, {22.0, 0.0}, {22.0, 1.0}, {20.0, 20.0}}) {
    for (const std::size_t rays : {2UL, 4UL, 91UL}) {
      const auto phi = equal_arc_angles(shape, rays);
      const double part = meridian_length(shape, 0.5 * kPi) / static_cast<double>(rays - 1);
      for (std::size_t i = 0; i + 1 < rays; ++i) {
        EXPECT_NEAR(meridian_length(shape, phi[i + 1]) - meridian_length(shape, phi[i]), part, 1e-12);
      }
      EXPECT_EQ(phi.front(), 0.0);
      EXPECT_EQ(phi.back(), 0.5 * kPi);
    }
  }
}

TEST(ConchoidRays, ACircleNeedsNoAdjustment) {
  const auto exact = equal_arc_angles({22.0, 0.0}, 91);
  const auto original = original_angles(91);
  for (std::size_t i = 0; i < 91; ++i) EXPECT_NEAR(exact[i], original[i], 1e-14);
}

TEST(ConchoidRays, AnArgumentPast1ByRoundingIsTheEnd) {
  EXPECT_EQ(adjusted_angles({1.0, 1.0 + 4e-16}, 7).back(), kPi);
  EXPECT_THROW(adjusted_angles({1.0, 1.001}, 7), std::invalid_argument);
}

TEST(ConchoidRays, RefusesTooFewRaysAndNoForm) {
  for (const std::size_t rays : {0UL, 1UL}) {
    EXPECT_THROW(original_angles(rays), std::invalid_argument);
    EXPECT_THROW(adjusted_angles(thesis_closed_form(), rays), std::invalid_argument);
    EXPECT_THROW(equal_arc_angles({}, rays), std::invalid_argument);
  }
  EXPECT_THROW(closed_form({22.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(equal_arc_angles({17.0, 20.0}, 4), std::invalid_argument);
  for (const ConchoidClosedForm& none : {ConchoidClosedForm{0.0, 0.0}, {-1.0, -1.0}, {std::nan(""), 1.0}}) {
    EXPECT_THROW(adjusted_angles(none, 4), std::invalid_argument);
  }
}

}  // namespace
}  // namespace impinge
