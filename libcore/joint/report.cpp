// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/report.hpp"

#include <stdexcept>
#include <utility>

namespace impinge {

ReportAnswer answer(Session& session, const ReportRequest& request, VolumeSettings how) {
  if (!session.joint->side)
    throw std::invalid_argument("side: a report needs to know it; give left or right");
  GapsRequest gaps;
  gaps.pose = request.pose;
  if (request.cartilage_mm) gaps.cartilage_mm = *request.cartilage_mm;
  gaps.outputs = {Output::gaps, Output::verdicts};
  LimitsRequest limits;
  limits.cartilage_mm = session.joint->joint.cartilage ? 0.0 : request.cartilage_mm.value_or(0.0);
  ReportAnswer found{answer(session, gaps), {}, {}, {}};
  if (request.has(ReportPart::limits)) found.limits = answer(session, limits);
  if (request.has(ReportPart::measures)) found.measures = answer(session, MeasureRequest{});
  if (request.has(ReportPart::volume))
    found.volume.emplace(answer(session, VolumeRequest{.width = request.width}, std::move(how)));
  return found;
}

}  // namespace impinge
