// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reported_surface.hpp"

#include "gap/gap_summary.hpp"
#include "hip/close_zones.hpp"

namespace impinge {

ReportedSurface reported(Surface surface, const SceneOptions& options, const Joint& joint,
                         const Measurement& measurement) {
  const bool is_ball = surface == Surface::ball;
  ReportedSurface v{surface,
                    is_ball ? options.ball : options.socket,
                    is_ball ? joint.ball : joint.socket,
                    is_ball ? measurement.ball : measurement.socket,
                    {},
                    {},
                    {},
                    joint.cartilage ? 1.0 : options.cartilage_mm};
  v.posed = v.part.mesh.vertices;
  if (is_ball) {
    for (Vec3& x : v.posed) x = to_socket(measurement.pose, x);
  }
  if (!v.gaps.gap.empty()) v.area = vertex_areas(v.part.mesh);  // else it was not scanned
  v.against_cartilage =
      joint.cartilage ? shares_of_cartilage(v.gaps.gap, v.posed, *joint.cartilage) : v.gaps.gap;
  return v;
}

}  // namespace impinge
