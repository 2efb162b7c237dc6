// SPDX-License-Identifier: GPL-3.0-or-later
// Poses at known distances from a contact, and how a method answers in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/ball_socket_pair.hpp"
#include "methods/method.hpp"

namespace impinge::lab {

// A pose near a contact.
struct BaselinePose {
  Pose pose;               // of the ball in the socket
  double beyond_mm = 0.0;  // way of the ball past the first contact; negative before it
  bool touches = false;    // exactly
};

// Which ways the ball is sent.
struct BaselineWays {
  std::size_t count = 10;  // of ways
  double turn = 0.6;       // radians, the largest turn before a way, about any axis
  double shift = 12.0;     // mm, the length of a way, in any direction
  std::uint64_t seed = 0;  // of turns and directions
};

// Fourteen poses of each way: 0.05, 0.1, 0.2, 0.5, 1, 2 and 4 mm before and after its first contact, as
// CGAL's tree decides it. Fewer ways where random ones do not bring the surfaces together.
std::vector<BaselinePose> baseline_poses(const BallSocketPair& joint, const BaselineWays& ways);

// How many poses a method got wrong.
struct BaselineVerdicts {
  std::size_t false_touches = 0;   // free poses that it calls touching
  std::size_t missed_touches = 0;  // touching poses that it calls free
  double wrong_within_mm = 0.0;    // the largest way from the contact at which an answer was wrong
};

// Asks the method about all of them.
BaselineVerdicts judge(const Touch& touches, const std::vector<BaselinePose>& poses);

}  // namespace impinge::lab
