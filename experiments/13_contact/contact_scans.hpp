// SPDX-License-Identifier: GPL-3.0-or-later
// The gaps of all vertices of a joint, by the kernels: the ways that are timed beside others.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "contact/culled_joint.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// What a scan writes, mm, each of the size of its surface; NaN where the other surface is not met.
struct JointGaps {
  std::vector<float> ball;    // of the vertices of the ball
  std::vector<float> socket;  // of the vertices of the socket
};
bool any_at_most_zero(const JointGaps& gaps);  // is there such a gap?

inline constexpr std::size_t kMostScanThreads = 2;  // of any way

// One way to find them.
struct ContactScan {
  std::string method;                                 // as results name it
  std::function<void(const Pose&, JointGaps&)> scan;  // in one pose; threads may ask at the same time
  std::size_t threads = 1;                            // that share the poses
};

// What is made of a joint, and what it writes to.
struct ContactScans {
  explicit ContactScans(const BallSocketPair& pair);  // makes the tables

  std::vector<ContactScan> ways;                 // every one
  std::array<JointGaps, kMostScanThreads> gaps;  // of each thread, of its last pose
};

// All gaps in all of the poses, which the threads of the way share.
void scan_poses(ContactScans& scans, const ContactScan& way, std::span<const Pose> poses);

// Largest error of a gap in a pose, by method, mm, against the faces at each vertex; a vertex without an
// answer has none. std::runtime_error where one is larger than a table allows, or where threads that share
// poses find other gaps than one.
std::map<std::string, double> scan_errors(ContactScans& scans, const CulledJoint& exact, const Pose& pose);

}  // namespace impinge::lab
