// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/scan_contact.hpp"

#include "files/formatted.hpp"
#include "gap/surface.hpp"
#include "joint/posed_gap.hpp"

namespace impinge {
namespace {

std::string place_of(const ScanContact& found) {
  return found.hours ? " at " + clock_text(*found.hours) + " o'clock" : "";
}

void warn(const std::string& line, SessionJoint& joint) {
  if (!line.empty()) joint.joint.warnings.push_back(line);
}

}  // namespace

ScanContact contact_in(SessionJoint& joint, const Pose& pose) {
  const BodyPairs::Verdict verdict = joint.bodies().verdict(pose);
  const BallSocketPair meshes{joint.main(Surface::ball), joint.main(Surface::socket)};
  ScanContact found;
  found.touch = verdict.contact == Contact::yes;
  if (const auto smallest = posed_gap(CulledJoint(meshes), meshes, pose)) {
    found.gap_mm = smallest->least.gap_mm;
    if (joint.dial) found.hours = joint.dial->hours(joint.axes * smallest->place);
  }
  const std::string ball = body_name(joint.joint.ball.parts, verdict.pair.ball);
  const std::string socket = body_name(joint.joint.socket.parts, verdict.pair.socket);
  found.bodies = (ball.empty() ? "ball" : ball) + " and " + (socket.empty() ? "socket" : socket);
  return found;
}

std::string describe_contact(const ScanContact& found, const std::string& pose,
                             const ScanContactOptions& options) {
  if (!found.touch) return {};
  const bool overlap = found.gap_mm && *found.gap_mm < 0.0;
  const std::string depth =
      overlap ? ", " + rounded_up(-*found.gap_mm, 3) + " mm deep along a ray" + place_of(found) : "";
  const std::string on_top =
      overlap && !options.overlap.empty()
          ? "; " + options.overlap + " with a little more than that depth asks for what comes on top"
          : "";
  return found.bodies + " touch " + pose + depth +
         ": what begins there is blocked; check the centre, the frame and the segmentation of both (a head "
         "and a liner of one nominal radius need their play)" +
         on_top;
}

std::string describe_threshold(const ScanContact& found, const std::string& pose,
                               const ScanContactOptions& options) {
  if (found.touch || !found.gap_mm || *found.gap_mm > options.threshold_mm) return {};
  return "the smallest gap " + pose + " is " + rounded_down(*found.gap_mm, 3) + " mm" + place_of(found) +
         formatted(", not above the %g mm of ", options.threshold_mm) + options.threshold +
         ": what asks for a gap of that size is blocked from the start; give less";
}

void warn_of_contact(SessionJoint& joint, const ScanContactOptions& options) {
  const auto& frames = joint.joint.frames;
  const bool turned = frames && frames->femur;
  const std::string start = turned ? "in the neutral pose of the landmarks" : "as scanned";
  const ScanContact found = contact_in(joint, Pose());
  warn(describe_contact(found, start, options), joint);
  if (options.threshold_mm > 0.0) warn(describe_threshold(found, start, options), joint);
  if (!turned) return;
  Pose scanned;
  scanned.rotation = frames->femur->transpose() * frames->pelvis;
  warn(describe_contact(contact_in(joint, scanned), "as scanned", options), joint);
}

}  // namespace impinge
