// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/certificate.hpp"

#include <cmath>
#include <vector>

#include "files/stopwatch.hpp"
#include "mesh/surface_vertices.hpp"

namespace impinge {
namespace {

// `exactly(i)` says whether vertex i is impinged.
template <class Exactly>
VertexVerdicts decide(const TriangleMesh& mesh, const GapEvidence& evidence, const Exactly& exactly) {
  const std::vector<bool> used = on_surface(mesh);
  VertexVerdicts verdicts;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const Verdict verdict =
        verdict_of(evidence.gap[i] - evidence.bound[i], evidence.gap[i] + evidence.bound[i], Cover::whole);
    verdicts.by_bound.clear += verdict == Verdict::clear ? 1U : 0U;
    verdicts.by_bound.impinged += verdict == Verdict::impinged ? 1U : 0U;
    const bool known = !std::isnan(evidence.gap[i]);
    verdicts.by_bound.undecided += verdict == Verdict::undecided && known ? 1U : 0U;
    verdicts.without_gap += known ? 0U : 1U;
    const Verdict truth = exactly(i) ? Verdict::impinged : Verdict::clear;
    verdicts.impinged += truth == Verdict::impinged ? 1U : 0U;
    verdicts.refuted += verdict != Verdict::undecided && verdict != truth ? 1U : 0U;
  }
  return verdicts;
}

}  // namespace

Certificate certify(const SurfaceOverlay& joint, const Pose& pose, const GapEvidence& ball,
                    const GapEvidence& socket) {
  Stopwatch watch;
  Certificate certificate;
  certificate.ball = decide(joint.ball(), ball, [&](std::size_t i) {
    return exactly_impinged(Surface::ball, joint.faces(Surface::socket),
                            to_socket(pose, joint.ball().vertices[i]));
  });
  certificate.socket = decide(joint.socket(), socket, [&](std::size_t i) {
    return exactly_impinged(Surface::socket, joint.faces(Surface::ball),
                            to_ball(pose, joint.socket().vertices[i]));
  });
  certificate.deepest = joint.deepest(pose);
  certificate.surfaces_impinged = certificate.deepest.has_value();
  certificate.seconds = watch.lap_s();
  return certificate;
}

}  // namespace impinge
