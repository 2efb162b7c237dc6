// SPDX-License-Identifier: GPL-3.0-or-later
// What the pose of the scan leaves: nothing where bones touch, or a gap for cartilage.
#pragma once

#include <functional>
#include <string>

#include "joint/session.hpp"

namespace impinge {

/// The session of the joint that `made` makes with the least overlap (JointInput::overlap_mm, tenths of a
/// millimetre) with which nothing touches as scanned; that is 0 where nothing does. std::runtime_error, one
/// line that begins with `option`, where 5 mm are not enough.
Session without_rest_contact(const std::function<Session(double overlap_mm)>& made,
                             const std::string& option);

/// The thickness that the scan leaves for cartilage: its smallest gap, mm, rounded down to 0.01.
/// std::runtime_error, one line that begins with `option`, where there is none.
double cartilage_of_scan(SessionJoint& joint, const std::string& option);

}  // namespace impinge
