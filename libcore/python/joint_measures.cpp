// SPDX-License-Identifier: GPL-3.0-or-later
// What the meshes measure, and a proof that needs no library.
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "joint/measures.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"
#include "python/poses.hpp"
#include "python/question_method.hpp"

namespace impinge::python {
namespace {

// One line that says what there is no certificate of.
ClearanceProof proven(PoseJoint& joint, const std::vector<Pose>& poses, const LimitRequest* limit) {
  try {
    return limit != nullptr ? joint.proof(*limit) : answer_proof(joint.joint(), poses.front());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("no certificate: ") + error.what());
  }
}

std::string certificate(PoseJoint& joint, const py::object& pose, const std::optional<std::string>& motion) {
  if (joint.joint().joint.frames)
    throw std::invalid_argument(
        "a certificate is about the meshes as they lie in their files; leave out landmarks=");
  if (joint.joint().joint.overlap_mm > 0.0)
    throw std::invalid_argument("a certificate is about the meshes as they are; leave out overlap_mm=");
  std::vector<Pose> poses{Pose{}};
  if (!pose.is_none()) poses = poses_of(joint.joint(), pose);
  if (poses.size() != 1)
    throw std::invalid_argument("poses: a certificate is of one pose, not of " +
                                std::to_string(poses.size()));
  LimitRequest limit;
  if (motion) {
    limit.growing = motion_name(*motion).name;
    if (!pose.is_none()) limit.start = motion_of(pose);
  }
  std::string text;
  without_lock(1, [&](std::size_t) { text = proof_text(proven(joint, poses, motion ? &limit : nullptr)); });
  return text;
}

}  // namespace

void bind_measures(JointClass& joint) {
  bind_question<MeasureRequest, MeasureAnswer>(
      joint, "measure",
      "The measures of both surfaces with their uncertainty, each beside what is published of it.");
  joint.def("certificate", &certificate, py::arg("pose") = py::none(), py::kw_only(),
            py::arg("motion") = py::none(),
            "The text of a proof that a pose, or with `motion` the way from it to the limit, is without "
            "contact, or that bodies touch in the pose; experiments/check_certificate.py checks it.");
}

}  // namespace impinge::python
