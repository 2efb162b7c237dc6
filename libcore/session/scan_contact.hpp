// SPDX-License-Identifier: GPL-3.0-or-later
// Contact in the pose of the scan, where no bones are in one another: every motion that begins there is
// blocked, and says nothing else.
#pragma once

#include <optional>
#include <string>

#include "session/session.hpp"

namespace impinge {

/// What a contact test says of the pose of the scan. What is not known is left out of the words.
struct ScanContact {
  bool touch = false;
  std::optional<double> gap_mm;  // the smallest gap along a ray; below 0 it is how deep they overlap
  std::optional<double> hours;   // its place on the dial
  std::string bodies = "ball and socket";  // which touch
};

/// The contact of a joint in a pose of the ball in the socket.
ScanContact contact_in(const SessionJoint& joint, const Pose& pose);

/// One line for the reader: how deep, where, and what to do; empty where nothing touches. `pose` names it, as
/// "as scanned".
std::string describe_contact(const ScanContact& found, const std::string& pose);

/// One line where the gap is below a threshold (mm) although nothing touches, so that each answer about a
/// gap of that size is "blocked"; else empty. `option` is how the threshold is given.
std::string describe_threshold(const ScanContact& found, const std::string& pose, double threshold_mm,
                               const std::string& option);

/// Adds these lines to the warnings of the joint for the pose that motions begin at, that of the scan; where
/// landmarks of the femur turned the ball to neutral, for both. No threshold: 0.
void warn_of_contact(SessionJoint& joint, double threshold_mm = 0.0, const std::string& option = "");

}  // namespace impinge
