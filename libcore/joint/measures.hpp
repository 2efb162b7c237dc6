// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of a session's joint.
#pragma once

#include <vector>

#include "hip/measure_list.hpp"
#include "joint/session.hpp"

namespace impinge {

/// The measures in the joint frame. With landmarks this is the frame of the pelvis, the femur in neutral
/// position. std::invalid_argument without a side.
std::vector<Measure> answer_measures(const SessionJoint& joint);

}  // namespace impinge
