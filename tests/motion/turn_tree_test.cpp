// SPDX-License-Identifier: GPL-3.0-or-later
// Two parts with a common point at an angle are never called apart until then, wherever the axis, the seam of
// azimuths and the borders of the parts are; and the search visits the pairs that brute force lists, in
// order.
#include "motion/turn_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/triangle_distance.hpp"
#include "motion/sinusoid.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

constexpr double kMargin = 1e-10;  // mm

struct Part {
  std::array<Vec3, 3> corner;
  std::size_t corners = 3;  // that count
};

// About the axis, far from it, across it, on it, thin, flat, of one or two corners.
Part random_part(test::Dice& dice) {
  const double size = std::pow(10.0, dice.between(-4.0, 1.5));
  const double off = dice.between(0.0, 1.0) < 0.3 ? 0.0 : dice.between(0.0, 50.0);
  const double azimuth = dice.between(0.0, 1.0) < 0.3 ? kPi : dice.between(-4.0, 4.0);
  const Vec3 middle(off * std::cos(azimuth), off * std::sin(azimuth), dice.between(-30.0, 30.0));
  Part part;
  for (Vec3& x : part.corner) {
    x = middle + size * Vec3(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
    if (dice.between(0.0, 1.0) < 0.1) x.y() = 0.0;
    if (dice.between(0.0, 1.0) < 0.05) x.head<2>().setZero();
  }
  part.corners = 1 + static_cast<std::size_t>(dice.between(0.0, 2.999));
  return part;
}

TurnBox box_of(const Part& part) {
  const std::array<TurnPoint, 3> points{TurnPoint(part.corner[0]), TurnPoint(part.corner[1]),
                                        TurnPoint(part.corner[2])};
  const std::array corners{&points[0], &points[1], &points[2]};
  const auto& [a, b, c] = part.corner;
  const std::array squared{a.squaredNorm(), squared_distance_to_segment(Vec3::Zero(), a, b),
                           squared_distance_to_triangle(Vec3::Zero(), a, b, c)};
  return turn_box(std::span(corners).first(part.corners), std::sqrt(squared[part.corners - 1]), kMargin);
}

// A corner, a point of a side, or one of the inside.
Vec3 random_point(const Part& part, test::Dice& dice) {
  double u = dice.between(0.0, 1.0) < 0.3 ? 0.0 : dice.between(0.0, 1.0);
  double v = dice.between(0.0, 1.0) < 0.3 ? 0.0 : dice.between(0.0, 1.0 - u);
  if (part.corners < 3) v = 0.0;
  if (part.corners < 2) u = 0.0;
  return part.corner[0] + u * (part.corner[1] - part.corner[0]) + v * (part.corner[2] - part.corner[0]);
}

TEST(TurnTree, PartsThatMeetAreNotApartBefore) {
  test::Dice dice(11);
  std::size_t later = 0;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Part turning = random_part(dice);
    Part resting = random_part(dice);
    const double angle = dice.between(0.0, 2.0 * kPi);
    const Vec3 shift = turned(random_point(turning, dice), angle) - random_point(resting, dice);
    for (Vec3& x : resting.corner) x += shift;
    const double from = dice.between(0.0, 1.0) < 0.5 ? 0.0 : dice.between(0.0, angle);
    const TurnBox a = box_of(turning);
    const TurnBox b = box_of(resting);
    ASSERT_LE(earliest_meeting(a, b, from), angle) << k;
    ASSERT_GE(earliest_meeting(a, b, from), from);
    if (earliest_meeting(a, b, 0.0) > 0.9 * angle) ++later;
    // in whatever boxes they are joined
    const TurnBox more = joined(box_of(random_part(dice)), joined(a, box_of(random_part(dice))));
    ASSERT_LE(earliest_meeting(more, joined(box_of(random_part(dice)), b), from), angle) << k;
  }
  EXPECT_GT(later, random_cases() / 10);  // a box says more than nothing
}

TEST(TurnTree, VisitsThePairsOfBruteForceInTheirOrder) {
  test::Dice dice(12);
  for (const std::size_t items : {1U, 2U, 3U, 17U, 64U}) {
    std::array<std::vector<TurnBox>, 2> boxes;
    std::array<TurnTree, 2> trees;
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<Vec3> places;
      for (std::size_t k = 0; k < items + side; ++k) {
        const Part part = random_part(dice);
        boxes[side].push_back(box_of(part));
        places.push_back(part.corner[0]);
      }
      trees[side] = TurnTree(boxes[side], order_by_place(places));
    }
    for (const double from : {0.0, 2.0}) {
      const double to = from + 1.0;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
      for (std::uint32_t i = 0; i < boxes[0].size(); ++i) {
        for (std::uint32_t j = 0; j < boxes[1].size(); ++j) {
          if (earliest_meeting(boxes[0][i], boxes[1][j], from) <= to) expected.emplace_back(i, j);
        }
      }
      std::vector<std::pair<std::uint32_t, std::uint32_t>> visited;
      double last = from;
      visit_meetings(trees[0], trees[1], from, to, [&](std::uint32_t i, std::uint32_t j) {
        const double angle = earliest_meeting(boxes[0][i], boxes[1][j], from);
        EXPECT_GE(angle, last - 1e-12);
        last = angle;
        visited.emplace_back(i, j);
        return to;
      });
      std::ranges::sort(visited);
      EXPECT_EQ(visited, expected);
    }
  }
}

TEST(TurnTree, StopsAtWhatIsFound) {
  test::Dice dice(13);
  std::vector<TurnBox> boxes;
  std::vector<Vec3> places;
  for (int k = 0; k < 50; ++k) {
    const Part part = random_part(dice);
    boxes.push_back(box_of(part));
    places.push_back(part.corner[0]);
  }
  const TurnTree tree(boxes, order_by_place(places));
  std::vector<double> all;
  for (const TurnBox& a : boxes) {
    for (const TurnBox& b : boxes) all.push_back(earliest_meeting(a, b, 0.0));
  }
  const double found = 1.5;
  const auto no_later =
      static_cast<std::size_t>(std::ranges::count_if(all, [&](double t) { return t <= found; }));
  ASSERT_LT(no_later,
            static_cast<std::size_t>(std::ranges::count_if(all, [](double t) { return t <= 6.0; })));
  std::size_t visits = 0;
  visit_meetings(tree, tree, 0.0, 6.0, [&](std::uint32_t, std::uint32_t) {
    ++visits;
    return found;
  });
  EXPECT_EQ(visits, no_later);
}

}  // namespace
}  // namespace impinge
