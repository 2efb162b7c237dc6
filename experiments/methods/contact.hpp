// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a joint touches, or its smallest gap, in many poses of a motion.
#pragma once

#include <span>

#include "methods/method.hpp"

namespace impinge::lab {

/// Gaps of all vertices in a pose, mm; NaN where the other surface is not met.
struct JointGaps {
  std::vector<float> ball;    // of the vertices of the ball
  std::vector<float> socket;  // of the vertices of the socket
};

/// What an answer is checked against.
enum class Contact {
  vertices,  // the exact test of every vertex
  faces,     // the exact overlay of the faces, but for the rounding of methods in float
  gaps       // the exact gaps: the largest error is reported
};

/// A joint as a method keeps it. It may keep scratch memory between poses: one thread at a time.
struct ContactQuery {
  Touch touches;                                        // what it says of a pose
  std::function<void(std::span<const Pose>)> run = {};  // what is timed; empty: `touches`, pose after pose
  /// Smallest gap or distance of a pose, mm, where the same work yields it.
  std::function<double(const Pose&)> smallest = {};
  /// Its gaps in a pose, until it is asked again.
  std::function<const JointGaps&(const Pose&)> gaps = {};
};

/// One setting, and how it comes to be.
struct ContactCase : Case {
  std::function<ContactQuery()> make = {};  // everything that is done once for a joint, which outlives it
  Contact contact = Contact::faces;
  Measure measure = Measure::radial;  // of its smallest gap
  bool few = false;                   // so slow that only some of the poses are asked
};

/// A case that answers touch only, by the Touch that make(pair) returns.
template <class Make>
ContactCase touch_only(std::string name, std::string label, int place, const BallSocketPair& pair,
                       const Make& make) {
  ContactCase one;
  static_cast<Case&>(one) = {std::move(name), std::move(label), "", place};
  one.make = [&pair, make] { return ContactQuery{make(pair)}; };
  return one;
}

}  // namespace impinge::lab
