// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a joint touches, in many poses of a motion.
#pragma once

#include <span>

#include "contact/culled_joint.hpp"
#include "methods/method.hpp"

namespace impinge::lab {

/// Gaps of all vertices in a pose, mm; NaN where the other surface is not met.
struct JointGaps {
  std::vector<float> ball;    // of the vertices of the ball
  std::vector<float> socket;  // of the vertices of the socket
};

/// What an answer must be.
enum class Contact {
  vertices,  // that of the exact test of every vertex
  faces,     // that of the exact overlay of the faces, but for the rounding of methods in float
  gaps       // that of gaps whose error is looked at
};

/// One way to ask.
struct ContactCase : Case {
  Touch touches;                                        // what it says of a pose
  Contact contact = Contact::faces;                     // and what that must be
  bool few = false;                                     // so slow that it is asked in one pose of several
  bool counted = false;                                 // are its instructions counted?
  std::function<void(std::span<const Pose>)> run = {};  // what is timed; empty: each pose by itself
  /// Its gaps in a pose, once for each of its threads.
  std::function<std::span<const JointGaps>(const Pose&)> gaps = {};
};

}  // namespace impinge::lab
