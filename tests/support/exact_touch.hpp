// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a pose is impinged, exactly, of a million poses too: all pairs of faces are asked of the first
// thousand, and must agree with the culled overlay (held against them in overlay_attack_test.cpp), which
// answers the others.
#pragma once

#include <cstddef>

#include <gtest/gtest.h>

#include "contact/culled_joint.hpp"
#include "contact/culled_overlay.hpp"
#include "gap/overlay.hpp"

namespace impinge::test {

class ExactTouch {
 public:
  /// The joint must outlive this.
  explicit ExactTouch(const BallSocketPair& joint)
      : all_(joint.ball, joint.socket), vertices_(joint), culled_(joint) {}
  explicit ExactTouch(const BallSocketPair&&) = delete;

  bool impinged(const Pose& pose) {
    const bool touches = culled_.impinged(pose, vertices_);
    if (asked_++ < kByAllPairs) {
      EXPECT_EQ(touches, all_.impinged(pose)) << "pose " << asked_;
    }
    return touches;
  }

  const CulledJoint& vertices() const { return vertices_; }

 private:
  static constexpr std::size_t kByAllPairs = 1000;

  SurfaceOverlay all_;
  CulledJoint vertices_;
  CulledOverlay culled_;
  std::size_t asked_ = 0;
};

}  // namespace impinge::test
