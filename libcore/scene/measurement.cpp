// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measurement.hpp"

#include <algorithm>
#include <stdexcept>

#include "files/stopwatch.hpp"
#include "gap/formatted.hpp"
#include "hip/motion.hpp"
#include "scene/planned_answer.hpp"
#include "scene/whole_tables.hpp"

namespace impinge {
namespace {

// Both scans held against the faces of the other surface.
class MeasuredOnFaces {
 public:
  MeasuredOnFaces(const Joint& joint, const Pose& pose)
      : ball_(joint.ball.mesh, 0.0), socket_(joint.socket.mesh, 0.0) {
    for (const Vec3& v : joint.ball.mesh.vertices) ball_places_.push_back(to_socket(pose, v));
    for (const Vec3& v : joint.socket.mesh.vertices) socket_places_.push_back(to_ball(pose, v));
  }

  // The bound of each gap is how far it can be from that of the faces. std::runtime_error where that is above
  // what was promised.
  void bound(double promised, Measurement& result) const {
    Stopwatch watch;
    for (SurfaceGaps* gaps : {&result.ball, &result.socket}) {
      const Surface of = gaps == &result.ball ? Surface::ball : Surface::socket;
      const bool ball = of == Surface::ball;
      for (std::size_t i = 0; i < gaps->gap.size(); ++i) {
        const CertifiedGap exact =
            measured_gap(of, ball ? socket_ : ball_, (ball ? ball_places_ : socket_places_)[i]);
        const double gap = gaps->gap[i];
        gaps->bound.push_back(std::max(gap - exact.low, exact.high - gap));
        if (gaps->bound.back() > promised) refuse(promised, of, i, gaps->bound.back());
      }
    }
    result.bound_ms = watch.lap_ms();
  }

  // Where the smallest gap is, by the bounds of the measurement.
  SmallestBetween smallest(const Measurement& result) const {
    return smallest_between({Surface::ball, socket_, ball_places_, result.ball.gap, result.ball.bound},
                            {Surface::socket, ball_, socket_places_, result.socket.gap, result.socket.bound});
  }

 private:
  [[noreturn]] static void refuse(double promised, Surface of, std::size_t vertex, double bound) {
    throw std::runtime_error(formatted(
        "option --max-error: %g mm is less than rounding leaves of the gap of %s vertex %zu, %.2g mm; ask "
        "for a larger error",
        promised, name(of).data(), vertex, bound));
  }

  NearFaces ball_;
  NearFaces socket_;
  std::vector<Vec3> ball_places_;    // in the frame of the socket
  std::vector<Vec3> socket_places_;  // in the frame of the ball
};

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

Measurement measure(const Joint& joint, const SceneOptions& options) {
  const Pose pose = scene_pose(options);
  const SceneOutputs& outputs = options.outputs;
  const bool bounds = outputs.bounds || outputs.verdicts;
  const bool whole = bounds && !options.max_error_mm;
  Measurement result =
      whole ? measure_whole_tables(joint, options, pose) : measure_gaps(joint, options, pose);
  if (bounds) {
    const MeasuredOnFaces faces(joint, pose);
    if (!whole) faces.bound(*options.max_error_mm, result);
    result.smallest = faces.smallest(result);
  }
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
