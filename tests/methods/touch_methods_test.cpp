// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, for a ball of radius R in a concentric shell of radius S > R, moved by t, both finely tessellated
// with vertices on the spheres:
//   |t| < S - R - sag   free
//   |t| > S - R + sag   touching
// sag: how far a face lies inside of its sphere, the only way in which the meshes differ from the spheres.
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/cgal_tree.hpp"
#include "methods/detection_benchmark.hpp"
#include "methods/fcl_obb.hpp"
#include "methods/pairwise.hpp"
#include "methods/vtk_collision.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

constexpr double kBall = 22.0;
constexpr double kShell = 26.0;

std::vector<std::unique_ptr<TouchMethod>> all_methods(const BallSocketPair& pair, double precision_deg) {
  DetectionBenchmark bench = make_detection_benchmark(pair, precision_deg);
  std::vector<std::unique_ptr<TouchMethod>> all = std::move(bench.methods);
  all.push_back(std::move(bench.oracle));
  all.push_back(make_vtk_collision(pair.ball, pair.socket));
  return all;
}

// A rotation and a translation of the given length, both random.
Pose random_pose(std::mt19937_64& random, double length) {
  std::normal_distribution<double> normal;
  Pose pose;
  pose.rotation = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                      .normalized()
                      .toRotationMatrix();
  pose.translation = length * Vec3(normal(random), normal(random), normal(random)).normalized();
  return pose;
}

// Largest distance of a face of the body from the sphere through its vertices.
double sag(const TriangleMesh& sphere) {
  double largest = 0.0;
  for (const Face& face : sphere.faces) {
    const Vec3 centroid = (corner(sphere, face, 0) + corner(sphere, face, 1) + corner(sphere, face, 2)) / 3.0;
    double edge = 0.0;
    for (std::size_t k = 0; k < 3; ++k) edge = std::max(edge, (corner(sphere, face, k) - centroid).norm());
    const double radius = corner(sphere, face, 0).norm();
    largest = std::max(largest, radius - std::sqrt(radius * radius - edge * edge));
  }
  return largest;
}

TEST(TouchMethods, AgreeWithTheKnownAnswerOfConcentricSpheres) {
  const BallSocketPair pair{radial_body(1000, [](const Vec3&) { return kBall; }),
                            radial_body(1000, [](const Vec3&) { return kShell; })};
  const double margin = sag(pair.ball) + sag(pair.socket);
  ASSERT_LT(margin, 1.0) << "too coarse to tell";
  std::mt19937_64 random(11);
  for (const auto& method : all_methods(pair, 0.5)) {
    for (int i = 0; i < 12; ++i) {
      const Pose free = random_pose(random, kShell - kBall - margin);
      const Pose touching = random_pose(random, kShell - kBall + margin);
      EXPECT_FALSE(method->touches(free)) << method->name() << " in pose " << i;
      EXPECT_TRUE(method->touches(touching)) << method->name() << " in pose " << i;
    }
  }
}

TEST(TouchMethods, ABallOutsideOfTheSocketIsFree) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  Pose away;
  away.translation = Vec3(0.0, 0.0, -100.0);
  DetectionBenchmark bench = make_detection_benchmark(pair, 1.0);
  for (const auto& method : bench.methods) {
    // The scans see a socket from inside alone: the ball's vertices are not in front of it, but its own
    // vertices are within no direction of the ball that would be nearer than the ball's surface.
    EXPECT_FALSE(method->touches(away)) << method->name();
  }
}

// Over random poses of the generated pair, from free to deeply touching. The two exact methods and the box
// trees have to agree always. The scans look at vertices alone, so they may differ where the smallest gap is
// within the sag of the faces.
TEST(TouchMethods, AgreeOverManyPosesOfTheGeneratedPair) {
  const PairShape shape = impinging_cam();
  const BallSocketPair pair = make_ball_socket_pair(1000, shape);
  const double margin = 2.0 * sag(make_ball_socket_pair(1000, PairShape{.cam_height = 0.0}).ball) + 0.1;
  ASSERT_LT(margin, 0.6);
  DetectionBenchmark bench = make_detection_benchmark(pair, 0.5);
  const auto vtk = make_vtk_collision(pair.ball, pair.socket);
  auto& rsid = dynamic_cast<TableScan<Rsid>&>(bench.method("rsid"));
  auto& usid = dynamic_cast<TableScan<Usid>&>(bench.method("usid"));
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> length(0.0, 6.0);
  int touching = 0;
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose pose = random_pose(random, length(random));
    const bool truth = bench.oracle->touches(pose);
    touching += truth ? 1 : 0;
    EXPECT_EQ(bench.method("pairwise").touches(pose), truth) << "pose " << i;
    EXPECT_EQ(bench.method("fcl_obb").touches(pose), truth) << "pose " << i;
    EXPECT_EQ(vtk->touches(pose), truth) << "pose " << i;
    for (const auto& [gap, touches] : {std::pair{rsid.smallest_gap(pose), rsid.touches(pose)},
                                       {usid.smallest_gap(pose), usid.touches(pose)}}) {
      if (std::abs(gap) <= margin) continue;
      ++compared;
      EXPECT_EQ(touches, truth) << "pose " << i << ", gap " << gap << " mm";
    }
  }
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 50);
  EXPECT_GT(compared, 60);
}

TEST(TouchMethods, DegenerateFacesChangeNothing) {
  BallSocketPair pair = make_ball_socket_pair(300);
  pair.ball.faces.push_back({0, 1, 1});
  pair.socket.faces.push_back({2, 2, 2});
  Pose touching;
  touching.translation = Vec3(0.0, 0.0, 5.0);
  for (const bool expected : {false, true}) {
    const Pose pose = expected ? touching : Pose{};
    EXPECT_EQ(make_pairwise(pair.ball, pair.socket)->touches(pose), expected);
    EXPECT_EQ(make_cgal_tree(pair.ball, pair.socket)->touches(pose), expected);
    EXPECT_EQ(make_fcl_obb(pair.ball, pair.socket)->touches(pose), expected);
    EXPECT_EQ(make_vtk_collision(pair.ball, pair.socket)->touches(pose), expected);
  }
}

TEST(TouchMethods, OnlyTheScansGiveDistances) {
  const DetectionBenchmark bench = make_detection_benchmark(make_ball_socket_pair(300), 1.0);
  ASSERT_EQ(bench.methods.size(), 4U);
  EXPECT_FALSE(bench.method("pairwise").gives_distance());
  EXPECT_FALSE(bench.method("fcl_obb").gives_distance());
  EXPECT_TRUE(bench.method("rsid").gives_distance());
  EXPECT_TRUE(bench.method("usid").gives_distance());
  EXPECT_THROW(bench.method("rapid"), std::out_of_range);
}

// Contract: the gap of a concentric pair is S - B at every vertex, up to the sag of the face on the other
// side.
template <SamplingScheme S>
void expect_the_gap_of_every_vertex() {
  const BallSocketPair pair{radial_body(1000, [](const Vec3&) { return kBall; }),
                            radial_body(1000, [](const Vec3&) { return kShell; })};
  TableScan<S> scan(pair.ball, pair.socket, make_tables<S>(pair, 1.0));
  const double smallest = scan.smallest_gap({});
  ASSERT_EQ(scan.gaps().size(), pair.ball.vertices.size() + pair.socket.vertices.size());
  const double margin = sag(pair.ball) + sag(pair.socket);
  for (const double gap : scan.gaps()) EXPECT_NEAR(gap, kShell - kBall, margin);
  EXPECT_EQ(smallest, *std::min_element(scan.gaps().begin(), scan.gaps().end()));
}

TEST(TableScan, GivesTheGapOfEveryVertex) {
  expect_the_gap_of_every_vertex<Rsid>();
  expect_the_gap_of_every_vertex<Usid>();
}

TEST(TableScan, WithoutAnySurfaceInSightThereIsNoGapAndNoTouch) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const Rsid scheme = Rsid::with_precision(1.0);
  auto empty = std::make_shared<const TablePair<Rsid>>(
      TablePair<Rsid>{RadialTable<Rsid>(scheme), RadialTable<Rsid>(scheme)});
  TableScan<Rsid> scan(pair.ball, pair.socket, empty);
  EXPECT_TRUE(std::isnan(scan.smallest_gap({})));
  EXPECT_FALSE(scan.touches({}));
}

}  // namespace
}  // namespace impinge::lab
