// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes on which methods are compared: generated pairs, hips, and real joints if given. Methods for points
// are asked for the socket's surface at the vertices of the posed ball, as in the first scan of the
// detection.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gap/pose.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

struct BenchmarkScene {
  std::string name;           // in the results
  BallSocketPair pair;        // centre frames, mm
  Pose pose;                  // of the ball, fixed
  Vec3 axis = Vec3::UnitX();  // of a motion of the ball, such as flexion

  // The surface that is measured, and its layer that faces the ball.
  const TriangleMesh& surface() const { return pair.socket; }
  static constexpr Layer kLayer = Layer::nearest;  // of the socket

  // The test points: vertices of the ball in the socket's frame, mm.
  std::vector<Vec3> queries() const {
    std::vector<Vec3> points;
    points.reserve(pair.ball.vertices.size());
    for (const Vec3& vertex : pair.ball.vertices) points.push_back(to_socket(pose, vertex));
    return points;
  }
};

// A pair with `faces` triangles per model. The ball is turned until the cam is 1 mm under the socket.
BenchmarkScene generated_scene(std::size_t faces);

// A hip of a preset with about `faces` triangles per model, posed as in real_scene(); its name is
// "hip_PRESET_TRIANGLES".
BenchmarkScene hip_scene(const std::string& preset, std::size_t faces);

// Pose number `turn` of a motion about the axis, with the ball a little off the centre: steps of 5 degrees up
// to 115 degrees, then from the start again.
Pose motion_pose(const Vec3& axis, int turn);

// A real joint, its ball turned by 10 degrees about +x.
BenchmarkScene real_scene(std::string name, BallSocketPair pair);

}  // namespace impinge::lab
