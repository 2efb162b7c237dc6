// SPDX-License-Identifier: GPL-3.0-or-later
// How far the joint turns.
#include <algorithm>

#include "joint/limits.hpp"
#include "joint/scan_contact.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"
#include "python/question_method.hpp"

namespace impinge::python {
namespace {

// A gap that is there from the start, where nothing touches, is worth a word.
void warn_of_start(PoseJoint& joint, const LimitsAnswer& found, py::dict& /*answer*/) {
  const auto blocked = [&](bool by_gap) {
    return std::find_if(found.limits.begin(), found.limits.end(), [&](const LimitDocument& limit) {
      return limit.state == LimitState::blocked && (limit.threshold_mm > 0.0) == by_gap;
    });
  };
  const auto limit = blocked(true);
  if (limit == found.limits.end() || blocked(false) != found.limits.end()) return;
  warn(
      describe_threshold(contact_in(joint.joint(), pose_of(joint.joint(), limit->start)), "at the start",
                         {.overlap = "", .threshold_mm = limit->threshold_mm, .threshold = "cartilage_mm="}));
}

}  // namespace

void bind_limits(JointClass& joint) {
  bind_question<LimitsRequest, LimitsAnswer>(
      joint, "limits", "How far each motion goes before bones meet, and what meets what.", &warn_of_start);
}

}  // namespace impinge::python
