// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a session's joint.
#pragma once

#include <vector>

#include "hip/measure_list.hpp"
#include "session/session.hpp"

namespace impinge {

/// In the joint frame, which landmarks make that of the pelvis, with the femur in neutral.
/// std::invalid_argument without a side.
std::vector<Measure> answer_measures(const SessionJoint& joint);

}  // namespace impinge
