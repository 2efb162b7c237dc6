// SPDX-License-Identifier: GPL-3.0-or-later
// How far the joint turns, as rows.
#include <limits>
#include <stdexcept>

#include <pybind11/stl.h>

#include "joint/scan_contact.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"
#include "python/poses.hpp"

namespace impinge::python {
namespace {

py::object or_none(bool there, double value) { return there ? py::object(py::float_(value)) : py::none(); }
py::object or_none(const std::optional<double>& value) {
  return or_none(value.has_value(), value.value_or(0));
}

// With the names of limits.csv and of summary.json.
py::dict limit_dict(const SessionJoint& joint, const std::string& motion, const LimitAnswer& answer) {
  const ToldLimit& told = answer.told;
  const TurnLimit& limit = told.limit;
  py::dict row;
  row["motion"] = motion;
  row["threshold_mm"] = told.threshold_mm;
  row["centre"] = answer.about;
  row["state"] = std::string(name(limit.state));
  row["low_deg"] = limit.low_deg;
  row["high_deg"] = limit.high_deg;
  row["centre_low_deg"] = told.common.low_deg;
  row["centre_high_deg"] = or_none(told.common.limited, told.common.high_deg);
  row["play_low_deg"] = told.play.low_deg;
  row["play_high_deg"] = or_none(told.play.limited, told.play.high_deg);
  row["half_mm_gap_deg"] = or_none(told.half_mm_gap_deg);
  row["leaves_ball_mesh_deg"] = or_none(limit.leaves_mesh_deg);
  row["clock"] = or_none(answer.hours);
  row["what"] = what_of(answer);
  row["position"] = py::none();
  if (limit.contact) {
    const Vec3 place = joint.axes.transpose() * limit.contact->place + answer.centre;
    row["position"] = py::make_tuple(place.x(), place.y(), place.z());
  }
  return row;
}

bool blocked(const LimitAnswer& answer) { return answer.told.limit.state == LimitState::blocked; }

std::vector<std::string> motions_of(const py::object& given) {
  std::vector<std::string> names;
  if (py::isinstance<py::str>(given)) return {given.cast<std::string>()};
  if (!given.is_none()) return given.cast<std::vector<std::string>>();
  for (const MotionName& motion : motion_names()) names.emplace_back(motion.name);
  return names;
}

py::list limits(PoseJoint& joint, const py::object& motions, const py::object& start, double cartilage_mm) {
  if (!(cartilage_mm >= 0.0 && cartilage_mm < std::numeric_limits<double>::infinity()))
    throw std::invalid_argument("cartilage_mm: is no thickness; give a number of mm, 0 or more");
  const Motion from = start.is_none() ? Motion{} : motion_of(start);
  py::list rows;
  bool below = false;  // is the gap, and nothing touches?
  for (const std::string& motion : motions_of(motions)) {
    std::optional<LimitAnswers> found;
    without_lock(1, [&](std::size_t) {
      found = joint.limits({.start = from, .growing = motion, .cartilage_mm = cartilage_mm});
    });
    rows.append(limit_dict(joint.joint(), motion, found->contact));
    if (found->socket) rows.append(limit_dict(joint.joint(), motion, *found->socket));
    rows.append(limit_dict(joint.joint(), motion, found->cartilage));
    below = below || (blocked(found->cartilage) && !blocked(found->contact));
  }
  if (below)
    warn(describe_threshold(contact_in(joint.joint(), pose_of(joint.joint(), from)), "at the start",
                            {.overlap = "", .threshold_mm = cartilage_mm, .threshold = "cartilage_mm="}));
  return rows;
}

}  // namespace

void bind_limits(JointClass& joint) {
  const auto none = py::none();
  joint.def("limits", &limits, py::arg("motions") = none, py::kw_only(), py::arg("start") = none,
            py::arg("cartilage_mm") = 4.0,
            "How far each motion goes from the start, degrees: a list of dicts, one a motion, threshold and "
            "centre, with the names of limits.csv.");
}

}  // namespace impinge::python
