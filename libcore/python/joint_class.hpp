// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module `impinge`, those of the class Joint above all. Docstrings are short;
// impinge/__init__.pyi says shapes and units.
#pragma once

#include <memory>
#include <vector>

#include <pybind11/numpy.h>

#include "python/pose_joint.hpp"

namespace impinge::python {

/// How Python holds a joint.
using SharedJoint = std::shared_ptr<PoseJoint>;
/// The binding of the class.
using JointClass = pybind11::class_<PoseJoint, SharedJoint>;

void bind_joint(pybind11::module_& module);
void bind_scheme(pybind11::module_& module);
void bind_making(JointClass& joint);        // read(), from_arrays(), from_hip()
void bind_pose_answers(JointClass& joint);  // gaps(), touch(), smallest_gap(), matrices()
void bind_questions(JointClass& joint);

/// The poses of the ball in the centre frame, from angles, a text of them or matrices (impinge/__init__.pyi
/// says which). Throws std::invalid_argument, one line, for anything else.
std::vector<Pose> poses_of(const SessionJoint& joint, const pybind11::object& given);

/// Poses as matrices, shape (n, 4, 4): x' = M x in the frame of the meshes, mm.
pybind11::array matrices_of(const SessionJoint& joint, const std::vector<Pose>& poses);

}  // namespace impinge::python
