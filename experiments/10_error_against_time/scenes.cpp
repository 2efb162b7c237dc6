// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_error_against_time/scenes.hpp"

#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

constexpr double kUnderTheSocket = -80.0;  // degrees about +y, for the cam at 130 degrees from the pole
constexpr double kTurn = 10.0;             // degrees

}  // namespace

BenchmarkScene generated_scene(std::size_t faces) {
  BenchmarkScene scene{"generated_" + std::to_string(faces), make_ball_socket_pair(faces), {}};
  scene.pose.rotation = Eigen::AngleAxisd(kUnderTheSocket * kDegree, Vec3::UnitY()).toRotationMatrix();
  return scene;
}

BenchmarkScene real_scene(std::string name, BallSocketPair pair) {
  BenchmarkScene scene{std::move(name), std::move(pair), {}};
  scene.pose.rotation = Eigen::AngleAxisd(kTurn * kDegree, Vec3::UnitX()).toRotationMatrix();
  return scene;
}

}  // namespace impinge::lab
