// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/pose_set.hpp"

#include <stdexcept>

#include <Eigen/Geometry>

#include "methods/table_scan.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {
namespace {

constexpr double kStep = 0.05;      // mm
constexpr int kSteps = 400;         // 20 mm
constexpr double kNear = 0.5;       // mm
constexpr double kTurn = 10.0;      // degrees
constexpr double kPrecision = 1.0;  // degrees

// The first pose along the axis in which the smallest gap is at most the target.
Pose approach(TableScan<Rsid>& scan, Pose pose, const Vec3& axis, double target) {
  for (int step = 0; step <= kSteps; ++step) {
    pose.translation = kStep * step * axis;
    if (scan.smallest_gap(pose) <= target) return pose;
  }
  throw std::runtime_error(
      "the ball does not reach the socket within 20 mm: check that the two meshes share a frame");
}

}  // namespace

Vec3 socket_axis(const TriangleMesh& socket) {
  Vec3 sum = Vec3::Zero();
  for (const Face& face : socket.faces) {
    const double area = area_vector(socket, face).norm();
    for (const VertexIndex v : face) sum += area * socket.vertices[v];
  }
  return sum.normalized();
}

std::vector<NamedPose> pose_set(const BallSocketPair& pair) {
  TableScan<Rsid> scan(pair.ball, pair.socket, make_tables<Rsid>(pair, kPrecision));
  const Vec3 axis = socket_axis(pair.socket);
  std::vector<NamedPose> poses;
  for (const double turn : {0.0, kTurn}) {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(turn * kDegree, axis.unitOrthogonal()).toRotationMatrix();
    const std::string suffix = turn > 0.0 ? ", turned by 10 degrees" : "";
    poses.push_back({"clear" + suffix, pose});
    poses.push_back({"near" + suffix, approach(scan, pose, axis, kNear)});
    poses.push_back({"touching" + suffix, approach(scan, pose, axis, -kNear)});
  }
  return poses;
}

void require_agreement(const TouchCase& method, const TouchCase& oracle,
                       const std::vector<NamedPose>& poses) {
  for (const NamedPose& named : poses) {
    const bool expected = oracle.touches(named.pose);
    if (method.touches(named.pose) == expected) continue;
    throw std::runtime_error(method.name + " disagrees with " + oracle.name + " in the pose \"" + named.name +
                             "\", where the surfaces " + (expected ? "touch" : "are free") +
                             ": its time means nothing until that is resolved");
  }
}

int count_touching(const TouchCase& method, const std::vector<NamedPose>& poses) {
  int touching = 0;
  for (const NamedPose& named : poses) touching += method.touches(named.pose) ? 1 : 0;
  return touching;
}

}  // namespace impinge::lab
