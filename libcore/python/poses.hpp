// SPDX-License-Identifier: GPL-3.0-or-later
// Poses as a script gives them.
#pragma once

#include <vector>

#include <pybind11/numpy.h>

#include "gap/pose.hpp"
#include "joint/session.hpp"

namespace impinge::python {

/// Angles, a text of them or matrices (impinge/__init__.pyi says which), as poses of the ball in the centre
/// frame. std::invalid_argument, one line, for anything else.
std::vector<Pose> poses_of(const SessionJoint& joint, const pybind11::object& given);

/// Matrices of poses, shape (n, 4, 4), x' = M x in the frame of the meshes, mm.
pybind11::array matrices_of(const SessionJoint& joint, const std::vector<Pose>& poses);

}  // namespace impinge::python
