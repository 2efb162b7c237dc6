// SPDX-License-Identifier: GPL-3.0-or-later
// Contact in the pose of the scan, where no bones are in one another: every motion that begins there is
// blocked, and says nothing else.
#pragma once

#include <optional>
#include <string>

#include "joint/session.hpp"

namespace impinge {

/// What a contact test says of the pose of the scan. What is not known is left out of the words.
struct ScanContact {
  bool touch = false;
  std::optional<double> gap_mm;  // the smallest gap along a ray; below 0 it is how deep they overlap
  std::optional<double> hours;   // its place on the dial
  std::string bodies = "ball and socket";  // which touch
};

/// The contact of a joint in a pose of the ball in the socket.
ScanContact contact_in(SessionJoint& joint, const Pose& pose);

/// How a reader gives what the lines below tell him to; empty: he cannot.
struct ScanContactOptions {
  std::string overlap{};      // an overlap that is no contact (JointInput::overlap_mm)
  double threshold_mm = 0.0;  // gaps of this size or less are asked about, too; 0: none are
  std::string threshold{};    // the option that gave it
};

/// One line for the reader: how deep, where, and what to do; empty where nothing touches. `pose` names it, as
/// "as scanned".
std::string describe_contact(const ScanContact& found, const std::string& pose,
                             const ScanContactOptions& options);

/// One line where the gap is not above the threshold although nothing touches, so that each answer about a
/// gap of that size is "blocked"; else empty.
std::string describe_threshold(const ScanContact& found, const std::string& pose,
                               const ScanContactOptions& options);

/// Adds these lines to the warnings of the joint for the pose that motions begin at, that of the scan; where
/// landmarks of the femur turned the ball to neutral, for both.
void warn_of_contact(SessionJoint& joint, const ScanContactOptions& options = {});

}  // namespace impinge
