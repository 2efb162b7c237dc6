// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/pose_set.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "methods/cgal.hpp"
#include "methods/table_check.hpp"
#include "methods/table_scan.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/thrown.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

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
