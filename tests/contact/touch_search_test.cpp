// SPDX-License-Identifier: GPL-3.0-or-later
// Every vertex whose gap is at the limit or less is shown, once; most of the others are not.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "contact/touch_search.hpp"
#include "mesh/generated_pair.hpp"
#include "support/poses.hpp"

namespace impinge {
namespace {

class NearItems : public ::testing::Test {
 protected:
  PosedTree posed(std::size_t scan, const Pose& pose) const {
    const CulledScan& culled = culled_.scans()[scan];
    return {culled.tree(), culled.limits(), CapMove(culled.scanned(), pose)};
  }
  double gap(std::size_t scan, const Pose& pose, std::uint32_t item) const {
    const CulledScan& culled = culled_.scans()[scan];
    return culled_.gap(culled.scanned(), CapMove(culled.scanned(), pose).place(culled.position(item)));
  }
  std::uint32_t items(std::size_t scan) const {
    return static_cast<std::uint32_t>(culled_.scans()[scan].tree().order().size());
  }

  BallSocketPair joint_ = make_ball_socket_pair(1500, impinging_cam());
  CulledJoint culled_{joint_};
  std::vector<Pose> poses_ = test::random_poses(12, 0.5, 2.0, 41);
};

TEST_F(NearItems, AreAllThatAreWithinTheLimit) {
  std::size_t shown = 0;
  std::size_t all = 0;
  for (const double limit : {-0.5, 0.0, 1.0}) {
    for (const Pose& pose : poses_) {
      for (const std::size_t scan : {0U, 1U}) {
        std::vector<int> times(items(scan), 0);
        auto visit = [&](std::uint32_t item) {
          ++times[item];
          return limit;
        };
        visit_near(posed(scan, pose), limit, visit);
        for (std::uint32_t item = 0; item < items(scan); ++item) {
          EXPECT_LE(times[item], 1);
          if (gap(scan, pose, item) <= limit) {
            EXPECT_EQ(times[item], 1) << limit;
          }
          shown += static_cast<std::size_t>(times[item]);
        }
        all += times.size();
      }
    }
  }
  EXPECT_LT(shown, all / 2);
}

// The limit falls to what was found: the least gap of all is among what is shown.
TEST_F(NearItems, HoldTheLeastGapWhileTheLimitFalls) {
  for (const Pose& pose : poses_) {
    double least = HUGE_VAL;
    for (std::uint32_t item = 0; item < items(0); ++item) least = std::fmin(least, gap(0, pose, item));
    double found = HUGE_VAL;
    std::size_t shown = 0;
    auto visit = [&](std::uint32_t item) {
      ++shown;
      return found = std::fmin(found, gap(0, pose, item));
    };
    visit_near(posed(0, pose), found, visit);
    EXPECT_EQ(found, least);
    EXPECT_LT(shown, items(0));
  }
}

TEST_F(NearItems, EndWhereNothingMattersAnyMore) {
  std::size_t shown = 0;
  auto visit = [&](std::uint32_t) {
    ++shown;
    return -HUGE_VAL;
  };
  visit_near(posed(0, Pose{}), 100.0, visit);
  EXPECT_EQ(shown, 1U);
}

}  // namespace
}  // namespace impinge
