// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/rest_contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/formatted.hpp"
#include "joint/touch.hpp"

namespace impinge {
namespace {

constexpr double kOverlapStep = 0.1;  // mm
constexpr double kMostOverlap = 5.0;  // mm; bones that overlap deeper do not just rest on each other

}  // namespace

Session without_rest_contact(const std::function<Session(double overlap_mm)>& made,
                             const std::string& option) {
  for (double overlap_mm = 0.0;;) {
    Session session = made(overlap_mm);
    const TouchAnswer rest = touch_in(*session.joint, scanned_pose(*session.joint));
    if (rest.contact.state != Contact::yes) return session;
    const double depth = rest.smallest_gap ? std::max(0.0, -rest.smallest_gap->gap_mm) : 0.0;
    overlap_mm += kOverlapStep * std::max(1.0, std::floor(depth / kOverlapStep));
    if (overlap_mm > kMostOverlap)
      throw std::runtime_error(option +
                               formatted(": the bones touch as scanned even where they may overlap by %g mm; "
                                         "check the centre, the frame and the segmentation of both",
                                         kMostOverlap));
  }
}

double cartilage_of_scan(SessionJoint& joint, const std::string& option) {
  const auto gap = touch_in(joint, scanned_pose(joint)).smallest_gap;
  const double thickness = gap ? std::floor(100.0 * gap->gap_mm) / 100.0 : 0.0;
  if (!(thickness > 0.0))
    throw std::runtime_error(option + ": the bones as scanned leave no gap for it; give a thickness in mm");
  return thickness;
}

}  // namespace impinge
