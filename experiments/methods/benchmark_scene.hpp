// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes on which methods are compared: generated pairs, hips, and real joints if given. Methods for points
// are asked for the surface of the socket at the posed ball's vertices, like the first scan of the detection.
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

  // The surface that is asked, and the layer of it that faces the ball.
  const TriangleMesh& surface() const { return pair.socket; }
  static constexpr Layer kLayer = Layer::nearest;  // of the socket

  // The points that are asked: vertices of the ball in the socket's frame, mm.
  std::vector<Vec3> queries() const {
    std::vector<Vec3> points;
    points.reserve(pair.ball.vertices.size());
    for (const Vec3& vertex : pair.ball.vertices) points.push_back(to_socket(pose, vertex));
    return points;
  }
};

// The pair of `faces` triangles a model, its ball turned until the cam is under the socket; free by 1 mm.
BenchmarkScene generated_scene(std::size_t faces);

// A hip of a preset with about `faces` triangles a model, posed as real_scene(); its name is
// "hip_PRESET_TRIANGLES".
BenchmarkScene hip_scene(const std::string& preset, std::size_t faces);

// Pose number `turn` of a motion about the axis, the ball a little off the centre: in steps of 5 degrees up
// to
// 115 degrees, then again from the start.
Pose motion_pose(const Vec3& axis, int turn);

// A real joint, its ball turned by 10 degrees about +x.
BenchmarkScene real_scene(std::string name, BallSocketPair pair);

}  // namespace impinge::lab
