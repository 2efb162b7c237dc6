// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that say for many poses of a motion whether a joint touches, or how large the smallest gap is.
#pragma once

#include <span>

#include "methods/method.hpp"

namespace impinge::lab {

/// Gaps of all vertices in a pose, mm; NaN where the other surface is not met.
struct JointGaps {
  std::vector<float> ball;    // of the vertices of the ball
  std::vector<float> socket;  // of the vertices of the socket
};

/// The reference for an answer.
enum class Contact {
  vertices,  // the exact test of every vertex
  faces,     // the exact overlay of the faces, apart from rounding in float
  gaps       // the exact gaps: the largest error is reported
};

/// A method prepared for a joint. It may use scratch memory between poses, so only one thread may call it.
struct ContactQuery {
  Touch touches;                                        // its answer for a pose
  std::function<void(std::span<const Pose>)> run = {};  // the timed work; empty: `touches` for each pose
  /// Smallest gap or distance of a pose, mm, where the same work yields it.
  std::function<double(const Pose&)> smallest = {};
  /// The gaps in a pose, valid until the next call.
  std::function<const JointGaps&(const Pose&)> gaps = {};
};

/// One setting of a method, and how it is prepared.
struct ContactCase : Case {
  std::function<ContactQuery()> make = {};  // what is done once for a joint, which must outlive the query
  Contact contact = Contact::faces;
  Measure measure = Measure::radial;  // of the smallest gap
  bool few = false;                   // so slow that only some of the poses are tested
};

/// A case that only answers touch, by the Touch that make(pair) returns.
template <class Make>
ContactCase touch_only(std::string name, std::string label, int place, const BallSocketPair& pair,
                       const Make& make) {
  ContactCase one;
  static_cast<Case&>(one) = {std::move(name), std::move(label), "", place};
  one.make = [&pair, make] { return ContactQuery{make(pair)}; };
  return one;
}

}  // namespace impinge::lab
