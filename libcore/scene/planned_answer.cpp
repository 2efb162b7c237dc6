// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/planned_answer.hpp"

#include <utility>

#include "files/stopwatch.hpp"
#include "scene/wanted_tables.hpp"

namespace impinge {
namespace {

SceneNeeds needs_of(const SceneOptions& options, const Pose& pose) {
  return {options.question, options.scan_ball, options.scan_socket, {pose}, options.max_error_mm};
}

// A table that keeps few entries still has a directory of all of them.
AnyScheme partly_kept(const SceneOptions& options) {
  constexpr double kDirectory = 2.0 * 4.0 / 4096.0;  // bytes an entry, both tables
  AnyScheme scheme(options.scheme, options.precision_deg);
  require_memory({scheme.size(), scheme.precision_deg(), kDirectory * static_cast<double>(scheme.size()),
                  "more than ", "a coarser --precision"});
  return scheme;
}

}  // namespace

Measurement measure_gaps(const Joint& joint, const SceneOptions& options, const Pose& pose) {
  Measurement result;
  result.pose = pose;
  Stopwatch watch;
  const AnyScheme scheme = partly_kept(options);
  SceneAnswer answer =
      answer_scene({joint.ball.mesh, joint.socket.mesh}, needs_of(options, pose), scheme, &result.left_out);
  result.precision_deg = options.max_error_mm ? 0.0 : scheme.precision_deg();
  result.entries = options.max_error_mm ? answer.cost.entries : scheme.size();
  result.bytes = answer.cost.bytes;
  result.way = std::move(answer.path.reason);
  result.ball.gap = std::move(answer.gaps.front().ball);
  result.socket.gap = std::move(answer.gaps.front().socket);
  result.scan_ms = watch.lap_ms();
  return result;
}

QuestionAnswer answer_question(const Joint& joint, const SceneOptions& options) {
  QuestionAnswer found;
  found.pose = scene_pose(options);
  Stopwatch watch;
  found.answer = answer_scene({joint.ball.mesh, joint.socket.mesh}, needs_of(options, found.pose),
                              partly_kept(options), &found.left_out);
  found.milliseconds = watch.lap_ms();
  return found;
}

}  // namespace impinge
