// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest entry is that of a loop over all entries; the widest gap is the covering radius.
#include "04_sampling_error/nearest_entry.hpp"

#include <gtest/gtest.h>

#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

TEST(NearestEntry, IsThatOfBruteForce) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(10.0);
    const NearestEntryFinder<S> finder(scheme);
    auto directions = uniform_directions(500, 21);
    for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
    for (const Vec3& u : directions) {
      double nearest = kPi;
      for (std::size_t i = 0; i < scheme.size(); ++i)
        nearest = std::min(nearest, angle_between(u, scheme.direction(i)));
      const NearestEntry found = finder(u);
      ASSERT_NEAR(found.angle, nearest, 1e-12) << S::name;
      ASSERT_NEAR(angle_between(u, scheme.direction(found.entry)), found.angle, 1e-12) << S::name;
    }
  });
}

// A scheme whose covering radius is too small.
struct Liar : Rsid {
  explicit Liar(const Rsid& scheme) : Rsid(scheme) {}
  double covering_radius() const { return 0.5 * Rsid::covering_radius(); }
  static Liar with_precision(double degrees) { return Liar(Rsid::with_precision(degrees)); }
  Liar() = default;
  [[maybe_unused]] friend bool operator==(const Liar&, const Liar&) = default;
};

TEST(NearestEntry, SaysSoWhenTheCoveringRadiusIsWrong) {
  const NearestEntryFinder<Liar> finder(Liar::with_precision(5.0));
  const Vec3 middle = to_direction({kPi / 2.0 + 2.5 * kDegree, 2.5 * kDegree});
  EXPECT_THROW(finder(middle), std::logic_error);
}

TEST(WidestGap, IsTheCoveringRadius) {
  const Rsid rsid = Rsid::with_precision(5.0);
  const auto directions = uniform_directions(20000, 22);
  const Gap gap = widest_gap(rsid, directions, nearest_entries(rsid, directions));
  EXPECT_NEAR(gap.angle, rsid.covering_radius(), 1e-3 * rsid.covering_radius());
  EXPECT_NEAR(NearestEntryFinder<Rsid>(rsid)(gap.direction).angle, gap.angle, 1e-12);
}

}  // namespace
}  // namespace impinge::lab
