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

void add_text(PoseJoint& /*joint*/, const CertifyAnswer& found, py::dict& answer) {
  answer["text"] = found.text;
}

}  // namespace

void bind_measures(JointClass& joint) {
  bind_question<MeasureRequest, MeasureAnswer>(
      joint, "measure",
      "The measures of both surfaces with their uncertainty, each beside what is published of it.");
  bind_question<CertifyRequest, CertifyAnswer>(
      joint, "certify",
      "A proof that a pose, or the way to the limit of a motion, is without contact, or that bodies touch in "
      "the pose; `text` is the "
      "certificate, which experiments/check_certificate.py checks.",
      &add_text);
}

}  // namespace impinge::python
