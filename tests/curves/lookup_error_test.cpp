// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolated minus true radius, by hand and where it must vanish.
#include "curves/lookup_error.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "curves/helix_entries.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/directions.hpp"

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

// Eq. 10's look-up is Usid's. On entries at equal travel it is an interpolation, whose error falls with the
// square of the spacing; on entries at equal arc it reads entries a little off, whose error falls slower.
TEST(LookupError, OfEq10DependsOnWhereTheEntriesStand) {
  const auto radius = [](const Vec3& u) { return 20.0 + u.x() * u.z() + u.y(); };
  const auto directions = test::random_directions(3000, 1);
  const auto errors = [&](std::size_t turns) {
    const Usid usid = Usid::with_turns(turns);
    const HelixEntries entries = thesis_entries(turns);
    std::vector<double> travel;
    std::vector<double> arc;
    for (std::size_t i = 0; i < usid.size(); ++i) {
      travel.push_back(radius(usid.direction(i)));
      const double phi = polar_angle_of_equal_arc(entries, i);
      arc.push_back(radius(to_direction({phi, 2.0 * entries.turns * phi})));
    }
    const auto stencil = [&](const Vec3& u) { return usid.stencil(u); };
    return std::pair{lookup_error(travel, stencil, radius, directions).root_mean_square,
                     lookup_error(arc, stencil, radius, directions).root_mean_square};
  };
  const auto coarse = errors(20);
  const auto fine = errors(80);
  EXPECT_GT(coarse.first / fine.first, 10.0);  // 16 but for the cells at the poles
  EXPECT_LT(coarse.second / fine.second, 6.0);
  EXPECT_GT(fine.second, 5.0 * fine.first);
}

}  // namespace
}  // namespace impinge
