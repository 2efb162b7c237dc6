// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, for a ball of radius R in a concentric shell of radius S > R, moved by t, both finely tessellated
// with vertices on the spheres:
//   |t| < S - R - sag   free
//   |t| > S - R + sag   touching
// sag: how far a face lies inside of its sphere, the only way in which the meshes differ from the spheres.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/cgal.hpp"
#include "methods/contact.hpp"
#include "methods/pose_set.hpp"
#include "methods/table_scan.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/dice.hpp"
#include "support/thrown.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

constexpr double kBall = 22.0;
constexpr double kShell = 26.0;

// A joint with all that says whether a pose touches.
struct Answers {
  explicit Answers(BallSocketPair of, double precision_deg) : pair(std::move(of)) {
    methods = cases_of(touch_methods(), &Method::touch, pair, precision_deg);
    methods.push_back({{"cgal_tree"}, make_cgal_tree(pair.ball, pair.socket)});
    for (const ContactCase& one : cases_of(contact_methods(), &Method::contact, pair))
      methods.push_back({{one.name}, one.make().touches});
  }

  BallSocketPair pair;
  std::vector<TouchCase> methods;
};

// Do they look at faces, and not at vertices alone? ODE and Bullet do in float, which is
// enough away from contact.
bool is_exact(const TouchCase& method) {
  return std::ranges::any_of(std::array{"pairwise", "cgal_", "fcl_", "ode_", "bullet_", "culled_faces"},
                             [&](const char* start) { return method.name.starts_with(start); });
}

// A rotation and a translation of the given length, both random.
Pose random_pose(test::Dice& dice, double length) {
  const Eigen::Matrix3d rotation = dice.rotation();
  return {rotation, length * dice.direction()};
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
  test::Dice dice(11);
  const Answers answers(pair, 0.5);
  for (const TouchCase& method : answers.methods) {
    for (int i = 0; i < 12; ++i) {
      const Pose free = random_pose(dice, kShell - kBall - margin);
      const Pose touching = random_pose(dice, kShell - kBall + margin);
      EXPECT_FALSE(method.touches(free)) << method.name << " in pose " << i;
      EXPECT_TRUE(method.touches(touching)) << method.name << " in pose " << i;
    }
  }
}

TEST(TouchMethods, ABallOutsideOfTheSocketIsFree) {
  Pose away;
  away.translation = Vec3(0.0, 0.0, -100.0);
  const BallSocketPair pair = make_ball_socket_pair(300);
  for (const TouchCase& method : cases_of(touch_methods(), &Method::touch, pair, 1.0)) {
    // The scans see a socket from inside alone: the ball's vertices are not in front of it, but its own
    // vertices are within no direction of the ball that would be nearer than the ball's surface.
    EXPECT_FALSE(method.touches(away)) << method.name;
  }
}

// Over random poses of the generated pair, from free to deeply touching. The two exact methods and the box
// trees have to agree always. The scans look at vertices alone, so they may differ where the smallest gap is
// within the sag of the faces.
TEST(TouchMethods, AgreeOverManyPosesOfTheGeneratedPair) {
  const PairShape shape = impinging_cam();
  const Answers answers(make_ball_socket_pair(1000, shape), 0.5);
  const BallSocketPair& pair = answers.pair;
  const double margin = 2.0 * sag(make_ball_socket_pair(1000, PairShape{.cam_height = 0.0}).ball) + 0.1;
  ASSERT_LT(margin, 0.6);
  const Touch oracle = make_cgal_tree(pair.ball, pair.socket);
  TableScan<Rsid> rsid(pair.ball, pair.socket, make_tables<Rsid>(pair, 0.5));
  TableScan<Usid> usid(pair.ball, pair.socket, make_tables<Usid>(pair, 0.5));
  test::Dice dice(5);
  int touching = 0;
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose pose = random_pose(dice, dice.between(0.0, 6.0));
    const bool truth = oracle(pose);
    touching += truth ? 1 : 0;
    for (const TouchCase& method : answers.methods) {
      if (is_exact(method)) {
        EXPECT_EQ(method.touches(pose), truth) << method.name << ", pose " << i;
      }
    }
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
  const Answers answers(pair, 1.0);
  for (const TouchCase& method : answers.methods) {
    EXPECT_FALSE(method.touches({})) << method.name;
    EXPECT_TRUE(method.touches(touching)) << method.name;
  }
}

TEST(TouchMethods, OnlyTheScansGiveDistances) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  std::vector<std::string> names;
  for (const TouchCase& method : cases_of(touch_methods(), &Method::touch, pair, 1.0)) {
    names.push_back(method.name);
    EXPECT_EQ(method.gives_distance, method.name == "rsid" || method.name == "usid");
    EXPECT_FALSE(method.label.empty());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"pairwise", "fcl_obb", "rsid", "usid"}));
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

TEST(PoseSet, IsClearNearAndTouchingAtEveryLevel) {
  for (const std::size_t faces : {300U, 1000U, 3000U}) {
    const BallSocketPair pair = make_ball_socket_pair(faces);
    const auto poses = pose_set(pair);
    ASSERT_EQ(poses.size(), 6U);
    TableScan<Rsid> scan(pair.ball, pair.socket, make_tables<Rsid>(pair, 0.5));
    for (const NamedPose& named : poses) {
      const double gap = scan.smallest_gap(named.pose);
      const bool clear = named.name.starts_with("clear");
      const double expected = clear ? 4.0 : named.name.starts_with("near") ? 0.5 : -0.5;
      EXPECT_NEAR(gap, expected, clear ? 0.5 : 0.15) << faces << " faces, " << named.name;
    }
    EXPECT_EQ(count_touching({{"cgal_tree"}, make_cgal_tree(pair.ball, pair.socket)}, poses), 2);
  }
}

TEST(PoseSet, SaysSoWhenTheSurfacesAreNowhereNear) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  BallSocketPair far = make_ball_socket_pair(300, PairShape{.socket_radius = 60.0});
  far.ball = pair.ball;
  EXPECT_THROW(pose_set(far), std::runtime_error);
}

TEST(PoseSet, AWrongMethodIsNamedWithThePose) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const TouchCase oracle{{"cgal_tree"}, make_cgal_tree(pair.ball, pair.socket)};
  const auto poses = pose_set(pair);
  for (const TouchCase& method : cases_of(touch_methods(), &Method::touch, pair, 0.5))
    EXPECT_NO_THROW(require_agreement(method, oracle, poses));
  const TouchCase blind{{"blind"}, [](const Pose&) { return false; }};  // wrong whenever the surfaces touch
  const std::string text = test::thrown<std::runtime_error>([&] { require_agreement(blind, oracle, poses); });
  EXPECT_NE(text.find("blind disagrees with cgal_tree"), std::string::npos) << text;
  EXPECT_NE(text.find("\"touching\""), std::string::npos) << text;
}

TEST(TableCheck, PassesARightTableAndNamesAWrongEntry) {
  const TriangleMesh ball = make_ball_socket_pair(300).ball;
  auto table = fill_exact(ball, Rsid::with_precision(5.0), Layer::farthest);
  const TableCheck check{table.scheme().size(), 1e-9, true};
  EXPECT_NO_THROW(require_radii(table, ball, Layer::farthest, check));
  const double right = table.radii()[1234];
  for (const double wrong : {right + 1e-6, kNoSurface}) {
    table.radii()[1234] = wrong;
    const std::string text =
        test::thrown<std::runtime_error>([&] { require_radii(table, ball, Layer::farthest, check); });
    EXPECT_EQ(text.rfind("entry 1234 ", 0), 0U) << text;
  }
  EXPECT_NO_THROW(require_radii(table, ball, Layer::farthest, {table.scheme().size(), 1e-9, false}));
}

}  // namespace
}  // namespace impinge::lab
