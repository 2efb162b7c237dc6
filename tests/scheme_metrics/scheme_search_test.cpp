// SPDX-License-Identifier: GPL-3.0-or-later
// The search finds what a scan over many precisions finds.
#include "scheme_metrics/scheme_search.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/every_scheme.hpp"

namespace impinge {
namespace {

TEST(SchemeSearch, LevelsClimbAndDescendsThroughTheSameSizes) {
  test::every_scheme([]<class S>() {
    SizeLevels<S> levels(5000);
    auto scheme = levels.first_of(4800);
    ASSERT_TRUE(scheme) << S::name;
    std::vector<std::size_t> sizes;
    for (; scheme && scheme->size() <= 5200; scheme = levels.larger(scheme->size())) {
      EXPECT_GE(scheme->size(), sizes.empty() ? 4800 : sizes.back() + 1) << S::name;
      sizes.push_back(scheme->size());
    }
    ASSERT_FALSE(sizes.empty()) << S::name;
    for (std::size_t above = 5201; !sizes.empty(); above = sizes.back(), sizes.pop_back()) {
      const auto smaller = levels.smaller(above);
      ASSERT_TRUE(smaller) << S::name;
      EXPECT_EQ(smaller->size(), sizes.back()) << S::name;
    }
  });
}

TEST(SchemeSearch, SchemesOfAnySizeAreThere) {
  test::every_scheme([]<class S>() {
    for (const std::size_t wanted : {500U, 1600U, 65160U}) {
      const auto nearest = scheme_nearest_size<S>(wanted);
      ASSERT_TRUE(nearest) << S::name;
      // The coarsest steps are those of a grid of 12 n^2: half of one is 1 / n = sqrt(12 / N).
      const double off = std::abs(static_cast<double>(nearest->size()) / static_cast<double>(wanted) - 1.0);
      EXPECT_LE(off, 1.2 * std::sqrt(12.0 / static_cast<double>(wanted)))
          << S::name << ' ' << nearest->size();
    }
  });
}

TEST(SchemeSearch, FindsTheNearestOfAllSizes) {
  std::size_t nearest = 0;
  for (std::size_t n = 2; n < 400; ++n) {
    const std::size_t size = 10 * n * n + 2;
    const auto off = [](std::size_t s) { return std::abs(static_cast<double>(s) - 52441.0); };
    if (off(size) < off(nearest)) nearest = size;
  }
  EXPECT_EQ(scheme_nearest_size<IcosahedralGnomonic>(52441)->size(), nearest);
  EXPECT_EQ(scheme_nearest_size<Rsid>(65160)->precision_deg(), 1.0);
}

TEST(SchemeSearch, SmallestWithinATargetIsTheSmallest) {
  const auto spacing = [](const auto& scheme) { return scheme.precision_deg(); };
  // Estimates too low, right and too high end at the same scheme.
  for (const std::size_t estimate : {15600U, 16110U, 16500U}) {
    const auto found = smallest_within<Rsid>(2.0, estimate, spacing);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->scheme, Rsid::with_precision(2.0)) << estimate;
    EXPECT_EQ(found->measured, 2.0);
  }
  EXPECT_FALSE(smallest_within<Rsid>(1.0, 16110, spacing));
  EXPECT_FALSE(scheme_of_precision<Rsid>(1.7));
}

}  // namespace
}  // namespace impinge
