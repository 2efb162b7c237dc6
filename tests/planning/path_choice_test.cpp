// SPDX-License-Identifier: GPL-3.0-or-later
// Caps pay for more than f faces / (v vertices - k) poses, and never where v vertices <= k.
#include "planning/path_choice.hpp"

#include <gtest/gtest.h>

namespace impinge {
namespace {

constexpr PathWork kHip{1, 12'000, 24'000};

PathWork with_poses(std::size_t poses) { return {poses, kHip.vertices, kHip.faces}; }

TEST(PathChoice, CapsPayFromTheFirstPoseThatCostsLess) {
  const std::size_t first = choose_path(kHip).pays_from;
  const auto whole = [](std::size_t poses) { return kLookPerVertex * 12'000.0 * static_cast<double>(poses); };
  const auto caps = [](std::size_t poses) {
    return kCapsPerFace * 24'000.0 + kCulledPerPose * static_cast<double>(poses);
  };
  EXPECT_LT(caps(first), whole(first));
  EXPECT_GE(caps(first - 1), whole(first - 1));
  EXPECT_FALSE(choose_path(with_poses(first - 1)).culled);
  EXPECT_TRUE(choose_path(with_poses(first)).culled);
}

TEST(PathChoice, AFewVerticesNeverPay) {
  const auto few = static_cast<std::size_t>(kCulledPerPose / kLookPerVertex);
  const PathChoice choice = choose_path({1'000'000'000, few, 10});
  EXPECT_FALSE(choice.culled);
  EXPECT_EQ(choice.pays_from, kNoPoses);
  EXPECT_NE(choice.reason.find("too few"), std::string::npos);
}

TEST(PathChoice, TheReasonNamesBothNumbers) {
  const std::string from = std::to_string(choose_path(kHip).pays_from) + " poses";
  const std::string one = choose_path(kHip).reason;
  EXPECT_NE(one.find("would pay from " + from), std::string::npos) << one;
  EXPECT_NE(one.find("there is 1"), std::string::npos) << one;
  const std::string many = choose_path(with_poses(1000)).reason;
  EXPECT_NE(many.find("pays from " + from), std::string::npos) << many;
  EXPECT_NE(many.find("there are 1000"), std::string::npos) << many;
}

}  // namespace
}  // namespace impinge
