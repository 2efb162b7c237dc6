// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measurement.hpp"

#include <algorithm>
#include <cmath>

#include "experiment/stopwatch.hpp"
#include "joint/motion.hpp"
#include "scene/planned_answer.hpp"
#include "scene/whole_tables.hpp"

namespace impinge {
namespace {

// They are those of the meshes, whatever the table.
void bracket_distances(const Joint& joint, Measurement& result) {
  Stopwatch watch;
  const EuclideanBracket ball(joint.ball.mesh);
  const EuclideanBracket socket(joint.socket.mesh);
  for (const Vec3& v : joint.ball.mesh.vertices)
    result.ball.distance.push_back(socket.at(to_socket(result.pose, v)));
  for (const Vec3& v : joint.socket.mesh.vertices)
    result.socket.distance.push_back(ball.at(to_ball(result.pose, v)));
  result.distance_ms = watch.lap_ms();
}

// What was not asked for, in words.
void say_left_out(const SceneOutputs& outputs, Measurement& result) {
  if (!outputs.bounds && !outputs.verdicts)
    result.left_out.push_back({Omission::error_bounds, "not asked for", 0.0});
  if (!outputs.distances) result.left_out.push_back({Omission::distances, "not asked for", 0.0});
  if (!outputs.verdicts) result.left_out.push_back({Omission::exact_verdicts, "not asked for", 0.0});
}

}  // namespace

Pose scene_pose(const SceneOptions& options) {
  const Eigen::Matrix3d axes = input_to_joint(options.axes);
  return {axes.transpose() * joint_rotation(options.motion, options.side) * axes, Vec3::Zero()};
}

double largest_bound(const SurfaceGaps& gaps) {
  double largest = 0.0;
  for (std::size_t i = 0; i < gaps.gap.size(); ++i) {
    if (!std::isnan(gaps.gap[i])) largest = std::max(largest, gaps.bound[i]);
  }
  return largest;
}

Measurement measure(const Joint& joint, const SceneOptions& options) {
  const Pose pose = scene_pose(options);
  const SceneOutputs& outputs = options.outputs;
  const bool whole = outputs.bounds || outputs.verdicts;
  Measurement result =
      whole ? measure_whole_tables(joint, options, pose) : measure_gaps(joint, options, pose);
  if (outputs.distances) bracket_distances(joint, result);
  if (outputs.verdicts) {
    result.certificate =
        certify({joint.ball.mesh, joint.socket.mesh}, pose, {result.ball.gap, result.ball.bound},
                {result.socket.gap, result.socket.bound});
  }
  say_left_out(outputs, result);
  return result;
}

}  // namespace impinge
