// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/pose_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/triangle_distance.hpp"
#include "methods/cgal.hpp"
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

constexpr double kMargin = 1e-6;  // mm, far above the rounding of a distance

// A triangle and a sphere about its centroid that holds it.
struct Held {
  Triangle corners;
  Vec3 middle;
  double reach = 0.0;  // mm
};

std::vector<Held> held_triangles(const TriangleMesh& mesh, const Pose& pose) {
  std::vector<Held> all;
  all.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    Held held;
    for (std::size_t k = 0; k < 3; ++k) held.corners[k] = to_socket(pose, corner(mesh, face, k));
    held.middle = (held.corners[0] + held.corners[1] + held.corners[2]) / 3.0;
    for (const Vec3& x : held.corners) held.reach = std::max(held.reach, (x - held.middle).norm());
    all.push_back(held);
  }
  return all;
}

std::vector<double> distances(const PointQuery& closest, const std::vector<Vec3>& points) {
  std::vector<double> out(points.size());
  closest.answer(points, out);
  return out;
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

double surface_distance(const BenchmarkScene& scene) {
  if (make_cgal_tree(scene.pair.ball, scene.pair.socket)(scene.pose)) return 0.0;
  const auto closest = make_cgal_closest(scene.pair.socket);
  const auto socket = held_triangles(scene.pair.socket, {});
  const auto ball = held_triangles(scene.pair.ball, scene.pose);
  double least = std::ranges::min(distances(closest, scene.queries()));
  std::vector<Vec3> middles;
  middles.reserve(ball.size());
  for (const Held& held : ball) middles.push_back(held.middle);
  const std::vector<double> from_middle = distances(closest, middles);
  for (std::size_t i = 0; i < ball.size(); ++i) {
    if (from_middle[i] - ball[i].reach > least + kMargin) continue;
    for (const Held& other : socket) {
      const double apart = (ball[i].middle - other.middle).norm() - ball[i].reach - other.reach;
      if (apart > least + kMargin) continue;
      least = std::min(least, std::sqrt(squared_distance_of_triangles(ball[i].corners, other.corners)));
    }
  }
  return least;
}

}  // namespace impinge::lab
