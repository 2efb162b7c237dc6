// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/certificate.hpp"

#include <cmath>
#include <vector>

#include "mesh/surface_vertices.hpp"

namespace impinge {
namespace {

Verdict verdict_by_bound(double gap, double bound) {
  return verdict_of(gap - bound, gap + bound, Cover::whole);
}

// Tests each vertex of the surface, in the pose, against the faces of the other one.
VertexVerdicts decide(const SurfaceOverlay& joint, const Pose& pose, Surface of,
                      const GapEvidence& evidence) {
  const bool ball = of == Surface::ball;
  const TriangleMesh& mesh = ball ? joint.ball() : joint.socket();
  const std::vector<bool> used = on_surface(mesh);
  VertexVerdicts verdicts;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const Verdict verdict = verdict_by_bound(evidence.gap[i], evidence.bound[i]);
    if (std::isnan(evidence.gap[i])) {
      ++verdicts.without_gap;
    } else {
      verdicts.by_bound.add(verdict);
    }
    const bool impinged = exactly_impinged(of, joint.faces(other(of)), to_other(of, pose, mesh.vertices[i]));
    const Verdict truth = impinged ? Verdict::impinged : Verdict::clear;
    verdicts.impinged += impinged ? 1U : 0U;
    verdicts.refuted += verdict != Verdict::undecided && verdict != truth ? 1U : 0U;
  }
  return verdicts;
}

}  // namespace

VerdictCount count_verdicts(std::span<const double> gap, std::span<const double> bound) {
  VerdictCount count;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!std::isnan(gap[i])) count.add(verdict_by_bound(gap[i], bound[i]));
  }
  return count;
}

Certificate certify(const SurfaceOverlay& joint, const Pose& pose, const GapEvidence& ball,
                    const GapEvidence& socket) {
  Certificate certificate;
  certificate.ball = decide(joint, pose, Surface::ball, ball);
  certificate.socket = decide(joint, pose, Surface::socket, socket);
  certificate.deepest = joint.deepest(pose);
  certificate.surfaces_impinged = certificate.deepest.has_value();
  return certificate;
}

}  // namespace impinge
