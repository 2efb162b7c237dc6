// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scan_contact.hpp"

#include "files/formatted.hpp"
#include "session/pose_series.hpp"

namespace impinge {
namespace {

ScanContact contact_in(const SessionJoint& joint, const PoseSeries& series, const Pose& pose) {
  const SeriesAnswer answer = series.answer(pose);
  ScanContact found;
  found.touch = answer.touch.value_or(false);
  if (answer.smallest) {
    found.gap_mm = answer.smallest->least.gap_mm;
    if (joint.dial) found.hours = joint.dial->hours(joint.axes * answer.smallest->place);
  }
  const bool apart = !found.gap_mm || *found.gap_mm > 0.0;
  if (joint.joint.has_parts() && apart) found.bodies = "bone beside the joint and the other side";
  return found;
}

std::string place_of(const ScanContact& found) {
  return found.hours ? " at " + clock_text(*found.hours) + " o'clock" : "";
}

void warn(const std::string& line, SessionJoint& joint) {
  if (!line.empty()) joint.joint.warnings.push_back(line);
}

}  // namespace

ScanContact contact_in(const SessionJoint& joint, const Pose& pose) {
  return contact_in(joint, PoseSeries(joint.joint, {}), pose);
}

std::string describe_contact(const ScanContact& found, const std::string& pose) {
  if (!found.touch) return {};
  const std::string depth = found.gap_mm && *found.gap_mm < 0.0
                                ? ", " + rounded_up(-*found.gap_mm, 3) + " mm deep" + place_of(found)
                                : "";
  return found.bodies + " touch " + pose + depth +
         ": what begins there is blocked; check the centre, the frame and the segmentation of both (a head "
         "and "
         "a liner of one nominal radius need their play)";
}

std::string describe_threshold(const ScanContact& found, const std::string& pose, double threshold_mm,
                               const std::string& option) {
  if (found.touch || !found.gap_mm || *found.gap_mm > threshold_mm) return {};
  return "the smallest gap " + pose + " is " + rounded_down(*found.gap_mm, 3) + " mm" + place_of(found) +
         formatted(", not above the %g mm of ", threshold_mm) + option +
         ": what asks for a gap of that size is blocked from the start; give less";
}

void warn_of_contact(SessionJoint& joint, double threshold_mm, const std::string& option) {
  const PoseSeries series(joint.joint, {});
  const auto& frames = joint.joint.frames;
  const bool turned = frames && frames->femur;
  const std::string start = turned ? "in the neutral pose of the landmarks" : "as scanned";
  const ScanContact found = contact_in(joint, series, Pose());
  warn(describe_contact(found, start), joint);
  if (threshold_mm > 0.0) warn(describe_threshold(found, start, threshold_mm, option), joint);
  if (!turned) return;
  Pose scanned;
  scanned.rotation = frames->femur->transpose() * frames->pelvis;
  warn(describe_contact(contact_in(joint, series, scanned), "as scanned"), joint);
}

}  // namespace impinge
