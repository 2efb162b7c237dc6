// SPDX-License-Identifier: GPL-3.0-or-later
// What the distance methods are compared on: the posed ball's vertices against the surface of the socket, as
// the first scan of the detection asks.
#pragma once

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
  Vec3 axis = Vec3::UnitX();  // of a motion of the ball, as flexion is

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

}  // namespace impinge::lab
