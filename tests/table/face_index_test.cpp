// SPDX-License-Identifier: GPL-3.0-or-later
// Every face that meets a direction within reach is listed, and the range holds its radius.
#include "table/face_index.hpp"

#include <algorithm>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

void expect_all_listed(const TriangleMesh& mesh, const std::vector<Vec3>& directions) {
  const FaceIndex index(mesh);
  std::vector<TriangleCone> cones;
  for (const Face& face : mesh.faces) cones.push_back(cone_of(mesh, face));
  for (const Vec3& u : directions) {
    // Asked about a direction at almost the reach from the one that is met.
    const Vec3 aside = Eigen::AngleAxisd(0.99 * index.reach(), u.unitOrthogonal()) * u;
    for (const Vec3& x : {Vec3(3.0 * u), aside}) {
      const auto near = index.near(x);
      for (std::size_t f = 0; f < cones.size(); ++f) {
        if (cones[f].edge_on() || !cones[f].contains(u)) continue;
        ASSERT_NE(std::ranges::find(near.faces, f), near.faces.end()) << u.transpose();
        ASSERT_GE(cones[f].radius(u), near.range.low);
        ASSERT_LE(cones[f].radius(u), near.range.high);
        ASSERT_GE(cones[f].radius(u), index.face(f).range.low);
        ASSERT_LE(cones[f].radius(u), index.face(f).range.high);
        ASSERT_LE(angle_between(index.face(f).cap.axis, u), index.face(f).cap.radius);
      }
    }
  }
}

TEST(FaceIndex, ListsEveryFaceThatIsMet) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  for (const TriangleMesh& mesh : {pair.ball, pair.socket, octahedron(20.0), cone()}) {
    auto directions = test::random_directions(300, 70);
    for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
    directions.resize(std::min<std::size_t>(directions.size(), 1200));
    for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
    expect_all_listed(mesh, directions);
  }
}

TEST(FaceIndex, ListsFewFacesADirection) {
  const FaceIndex index(make_ball_socket_pair(3000).ball);
  double listed = 0.0;
  const auto directions = test::random_directions(1000, 71);
  for (const Vec3& u : directions) listed += static_cast<double>(index.near(u).faces.size());
  EXPECT_LT(listed / static_cast<double>(directions.size()), 80.0);
  EXPECT_LT(index.bytes(), 3000U * 2000U);
}

TEST(FaceIndex, OfNoFacesListsNone) {
  const FaceIndex index(TriangleMesh{});
  EXPECT_TRUE(index.near(Vec3::UnitX()).faces.empty());
  EXPECT_TRUE(index.near(Vec3::UnitX()).range.empty());
}

}  // namespace
}  // namespace impinge
