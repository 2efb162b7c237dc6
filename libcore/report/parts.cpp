// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page.hpp"
#include "report/plots.hpp"
#include "report/scene.hpp"
#include "report/volume_picture.hpp"

namespace impinge {

ReportParts report_parts(const SessionJoint& joint, const JointNames& names, const ReportRequest& request,
                         const ReportAnswer& found) {
  ReportParts parts{.ball = names.ball, .socket = names.socket, .doubts = joint.joint.doubts};
  parts.joint = json_of(describe(joint, names));
  parts.request = json_of(request);
  parts.answer = json_of(found);
  parts.scene = report_scene(joint, found.gaps);
  if (const std::optional<ClockMap> map = clock_map(joint, found.gaps))
    parts.clock = clock_plot(*map, parts.answer["gaps"]);
  if (found.limits) parts.limits = limits_plot(parts.answer["limits"]);
  if (found.volume) parts.volume = volume_picture(found.volume->volume, *joint.side);
  if (found.measures) parts.measures = measures_plot(parts.answer["measures"]);
  return parts;
}

}  // namespace impinge
