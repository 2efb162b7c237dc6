// SPDX-License-Identifier: GPL-3.0-or-later
// The class Joint of the module, in parts.
#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "python/pose_joint.hpp"

namespace impinge::python {

/// How Python holds a joint.
using SharedJoint = std::shared_ptr<PoseJoint>;
/// The binding of the class.
using JointClass = pybind11::class_<PoseJoint, SharedJoint>;

void bind_making(JointClass& joint);        // read(), from_arrays(), from_hip()
void bind_pose_answers(JointClass& joint);  // gaps(), touch(), smallest_gap(), matrices()
void bind_limits(JointClass& joint);        // limits()
void bind_volume(JointClass& joint);        // volume()
void bind_change(JointClass& joint);        // resect(), orient()
void bind_measures(JointClass& joint);      // measures(), certificate()

}  // namespace impinge::python
