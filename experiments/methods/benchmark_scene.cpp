// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/benchmark_scene.hpp"

#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

constexpr double kUnderTheSocket = -80.0;  // degrees about +y, for the cam at 130 degrees from the pole
constexpr double kTurn = 10.0;             // degrees

constexpr int kMotionTurns = 24;
constexpr double kMotionStep = 5.0;  // degrees

}  // namespace

BenchmarkScene generated_scene(std::size_t faces) {
  BenchmarkScene scene{
      "generated_" + std::to_string(faces), make_ball_socket_pair(faces), {}, -Vec3::UnitY()};
  scene.pose.rotation = Eigen::AngleAxisd(kUnderTheSocket * kDegree, Vec3::UnitY()).toRotationMatrix();
  return scene;
}

BenchmarkScene hip_scene(const std::string& preset, std::size_t faces) {
  Hip hip = make_hip(hip_preset(preset), faces);
  return real_scene("hip_" + preset + "_" + std::to_string(faces),
                    {std::move(hip.ball), std::move(hip.socket)});
}

Pose motion_pose(const Vec3& axis, int turn) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(kMotionStep * (turn % kMotionTurns) * kDegree, axis).toRotationMatrix();
  pose.translation = Vec3(0.1, -0.2, 0.05);
  return pose;
}

BenchmarkScene real_scene(std::string name, BallSocketPair pair) {
  BenchmarkScene scene{std::move(name), std::move(pair), {}, Vec3::UnitX()};
  scene.pose.rotation = Eigen::AngleAxisd(kTurn * kDegree, Vec3::UnitX()).toRotationMatrix();
  return scene;
}

}  // namespace impinge::lab
