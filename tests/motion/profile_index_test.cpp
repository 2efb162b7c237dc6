// SPDX-License-Identifier: GPL-3.0-or-later
// Every box that overlaps is visited, once, and no other: by brute force, on grids that put borders on
// borders.
#include "motion/profile_index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/infinity.hpp"
#include "support/dice.hpp"

namespace impinge {
namespace {

// Its ends are multiples of a step, so that some boxes only touch, and some are points or lines.
ProfileBox random_box(test::Dice& dice, double step, double widest, bool flat) {
  const auto on_grid = [&](double most) { return step * std::floor(dice.between(0.0, most) / step); };
  const double z = flat ? 3.0 : on_grid(50.0);
  const double r = on_grid(50.0);
  return {z, flat ? z : z + on_grid(widest), r, r + on_grid(widest)};
}

TEST(ProfileIndex, VisitsEveryOverlapOnce) {
  test::Dice dice(41);
  for (const double step : {0.01, 1.0, 50.0 / 48.0}) {
    for (const double widest : {2.0, 60.0}) {
      for (const bool flat : {false, true}) {
        std::vector<ProfileBox> boxes;
        for (int k = 0; k < 400; ++k) boxes.push_back(random_box(dice, step, widest, flat));
        const ProfileBox all{-kInfinity, kInfinity, -kInfinity, kInfinity};
        for (const ProfileBox& within : {all, ProfileBox{-kInfinity, 30.0, 10.0, 40.0}}) {
          const ProfileIndex index(boxes, within);
          std::size_t overlaps = 0;
          for (int k = 0; k < 200; ++k) {
            const ProfileBox box = random_box(dice, step, widest, flat);
            if (!within.overlaps(box)) continue;
            std::vector<std::uint32_t> found;
            std::vector<std::uint32_t> expected;
            index.visit(box, [&](std::uint32_t i) { found.push_back(i); });
            std::sort(found.begin(), found.end());
            EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
              if (boxes[i].overlaps(box) && boxes[i].overlaps(within)) expected.push_back(i);
            }
            overlaps += expected.size();
            EXPECT_EQ(found, expected);
          }
          EXPECT_GT(overlaps, 0U);
        }
      }
    }
  }
}

}  // namespace
}  // namespace impinge
