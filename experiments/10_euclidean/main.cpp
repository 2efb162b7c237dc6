// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How much larger than the Euclidean distance are radial gaps, and where in a joint?
// @writes    euclidean
// @bones     yes
// @timing    no
// @seconds   2 90
// @links     harness real_joints reference gap
//
// The vertices of each surface are measured against the other surface, in several poses, and compared with
// the exact distance to the nearest point.

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "10_euclidean/distance_study.hpp"
#include "gap/pose.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/statistics.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kTriangles = 12000;  // of each generated model
constexpr std::size_t kTrianglesInQuick = 3000;
constexpr double kTurnDeg = 30.0;
constexpr double kNeckTurnDeg = 60.0;  // brings the neck under the rim
constexpr double kNeckRadius = 14.0;   // mm
constexpr double kNeckLength = 50.0;   // mm from the centre

struct NamedPose {
  std::string name;
  Pose pose;
};

// The ball of the pair without its cam, on a round neck along -z, so that steep faces are next to a rim.
BallSocketPair pair_with_neck(std::size_t triangles) {
  PairShape shape;
  const auto radius = [&](const Vec3& u) {
    const double neck = u.z() < 0.0 ? kNeckRadius / std::max(std::hypot(u.x(), u.y()), 1e-9) : 0.0;
    return std::max(shape.head_radius, std::min(neck, kNeckLength));
  };
  return {radial_body(triangles, radius), make_ball_socket_pair(triangles, shape).socket};
}

// As scanned, and turned about each axis of the input frame.
std::vector<NamedPose> poses(bool quick, double turn_deg) {
  std::vector<NamedPose> list{{"as scanned", {}}};
  constexpr std::array kAxes{"x", "y", "z"};
  for (Eigen::Index k = 0; k < (quick ? 1 : 3); ++k) {
    const Eigen::AngleAxisd turn(turn_deg * kDegree, Vec3::Unit(k));
    const std::string angle = std::to_string(static_cast<int>(turn_deg)) + " degrees about ";
    list.push_back({angle + kAxes[static_cast<std::size_t>(k)], {turn.toRotationMatrix(), Vec3::Zero()}});
  }
  return list;
}

struct Rows {
  Result& result;
  std::string joint;
  std::string pose;

  void add(std::string_view vertices_of, const TriangleMesh& other, const std::vector<Vec3>& points) const {
    for (const DistanceShare& share : distance_shares(other, points)) {
      if (share.gap.empty()) continue;
      result.table.add_row({joint, pose, vertices_of, share.zone, share.gap.size(), quantile(share.gap, 0.5),
                            quantile(share.gap, 0.9), quantile(share.gap, 1.0)});
    }
  }
};

struct JointPoses {
  std::string joint;
  const BallSocketPair& meshes;
  const std::vector<NamedPose>& poses;
};

void add_joint(Result& result, const JointPoses& now) {
  const auto& [joint, meshes, poses] = now;
  for (const auto& [name, pose] : poses) {
    const Rows rows{result, joint, name};
    std::vector<Vec3> ball = meshes.ball.vertices;
    for (Vec3& x : ball) x = to_socket(pose, x);
    rows.add("ball", meshes.socket, ball);
    std::vector<Vec3> socket = meshes.socket.vertices;
    for (Vec3& x : socket) x = to_ball(pose, x);
    rows.add("socket", meshes.ball, socket);
  }
}

void body(DriverRun& run) {
  Result result{"euclidean",
                "How far above the Euclidean distance are radial gaps, and where in a joint?",
                {{{"joint", "", "generated ones, and the folders of real ones"},
                  {"pose", "", "of the ball"},
                  {"vertices_of", "", "surface whose vertices were looked at"},
                  {"zone", "",
                   "facing: met at less than 20 degrees to the normal; oblique: 45; steep: "
                   "more; rim: a rim or fold is nearer than the end of the gap"},
                  {"vertices", "1", "in that zone"},
                  {"gap_median", "1", "gap over exact distance"},
                  {"gap_p90", "1", "the same, exceeded by 1 in 10"},
                  {"gap_max", "1", "the same, largest"}}}};
  const std::size_t triangles = run.quick() ? kTrianglesInQuick : kTriangles;
  result.parameters = {{"triangles", triangles},
                       {"turn_deg", kTurnDeg},
                       {"neck_turn_deg", kNeckTurnDeg},
                       {"neck_radius_mm", kNeckRadius},
                       {"neck_length_mm", kNeckLength}};
  const std::vector<NamedPose> turned = poses(run.quick(), kTurnDeg);
  add_joint(result, {"generated", make_ball_socket_pair(triangles, impinging_cam()), turned});
  add_joint(result, {"generated with a neck", pair_with_neck(triangles), poses(run.quick(), kNeckTurnDeg)});
  if (run.bones) {
    for (const RealJoint& joint : read_real_joints(*run.bones, run.progress)) {
      run.progress.say("distances of " + joint.subject);
      add_joint(result, {joint.subject, joint.meshes, turned});
    }
  }
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"10_euclidean", "Radial gaps beside exact Euclidean distances.",
                                   /*takes_bones=*/true},
                                  body);
}
