// SPDX-License-Identifier: GPL-3.0-or-later
// What the pose of the scan allows: an overlap that is not called contact, or a gap for cartilage.
#pragma once

#include <functional>
#include <string>

#include "joint/session.hpp"

namespace impinge {

/// The session of the joint that `made` makes with the least overlap (JointInput::overlap_mm, in steps of 0.1
/// mm) for which nothing touches as scanned; 0 if nothing does. Throws std::runtime_error, one line that
/// begins with `option`, if 5 mm are not enough.
Session without_rest_contact(const std::function<Session(double overlap_mm)>& made,
                             const std::string& option);

/// The thickness that the scan leaves for cartilage: its smallest gap, mm, rounded down to 0.01. Throws
/// std::runtime_error, one line that begins with `option`, if there is none.
double cartilage_of_scan(SessionJoint& joint, const std::string& option);

}  // namespace impinge
