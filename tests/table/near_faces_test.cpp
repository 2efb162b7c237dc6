// SPDX-License-Identifier: GPL-3.0-or-later
// What NearFaces says of a cap of directions is true of every direction in it: each is asked of every face.
#include "table/near_faces.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/directions.hpp"
#include "support/soup.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

constexpr double kMargin = 2.0 * kDegree;

static_assert(!std::is_constructible_v<NearFaces, TriangleMesh, double>, "the mesh is kept by reference");

// A direction within `angle` of u.
Vec3 beside(const Vec3& u, const Vec3& way, double angle) {
  const Vec3 aside = (way - way.dot(u) * u).normalized();
  return std::cos(angle) * u + std::sin(angle) * aside;
}

void expect_true_of(const TriangleMesh& mesh) {
  const NearFaces faces(mesh, kMargin);
  const RayCaster oracle(mesh);
  auto directions = test::random_directions(400, 5);
  for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
  directions.resize(std::min<std::size_t>(directions.size(), 1200));
  for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
  const auto ways = test::random_directions(directions.size() * 8, 6);
  std::size_t met = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const NearFaces::Near near = faces.near(30.0 * directions[i]);
    for (std::size_t k = 0; k < 8; ++k) {
      const double angle = 0.999 * kMargin * static_cast<double>(k) / 7.0;
      const Vec3 u = beside(directions[i], ways[8 * i + k], angle);
      for (const Layer layer : {Layer::nearest, Layer::farthest}) {
        const double radius = oracle.cast(u, layer);
        if (!near.rim) {
          EXPECT_EQ(std::isnan(radius), near.nothing());
        }
        if (std::isnan(radius)) {
          EXPECT_TRUE(std::isnan(faces.radius(u, near, layer)));
          continue;
        }
        ++met;
        EXPECT_FALSE(near.nothing());
        EXPECT_LE(near.range.low, radius);
        EXPECT_GE(near.range.high, radius);
        EXPECT_NEAR(faces.radius(u, near, layer), radius, 1e-9 * radius);
      }
    }
  }
  EXPECT_GT(met, 500U);
}

TEST(NearFaces, KnowsAClosedBall) { expect_true_of(make_ball_socket_pair(1200).ball); }
TEST(NearFaces, KnowsAnOpenSocket) { expect_true_of(make_ball_socket_pair(1200).socket); }
TEST(NearFaces, KnowsFewLargeFaces) {
  expect_true_of(octahedron(20.0));
  expect_true_of(cone());
}

TEST(NearFaces, ListsFewFacesADirection) {
  const TriangleMesh ball = make_ball_socket_pair(3000).ball;
  const NearFaces faces(ball, 0.0);
  double listed = 0.0;
  const auto directions = test::random_directions(1000, 71);
  for (const Vec3& u : directions) listed += static_cast<double>(faces.near(u).faces.size());
  EXPECT_LT(listed / static_cast<double>(directions.size()), 80.0);
  EXPECT_LT(faces.bytes(), 3000U * 2000U);
}

TEST(NearFaces, OfNoFacesListsNone) {
  const TriangleMesh none;
  const NearFaces faces(none, 0.0);
  EXPECT_TRUE(faces.near(Vec3::UnitX()).faces.empty());
  EXPECT_TRUE(faces.near(Vec3::UnitX()).nothing());
}

TEST(FaceCap, HoldsDirectionsAndRadiiOfItsFace) {
  for (const TriangleMesh& mesh : {make_ball_socket_pair(1000).socket, octahedron(20.0), cone()}) {
    for (const Face& face : mesh.faces) {
      const TriangleCone cone = cone_of(mesh, face);
      const FaceCap seen = face_cap(cone.corners());
      if (cone.edge_on()) continue;
      for (const Vec3& u : test::feature_directions({mesh.vertices, {face}})) {
        if (!cone.contains(u)) continue;
        ASSERT_LE(angle_between(seen.cap.axis, u), seen.cap.radius);
        ASSERT_GE(cone.radius(u), seen.range.low);
        ASSERT_LE(cone.radius(u), seen.range.high);
      }
    }
  }
}

TEST(NearFaces, NothingIsCertainAboutTheCentreOrAFaceThroughIt) {
  TriangleMesh mesh = octahedron(20.0);
  const NearFaces round(mesh, kMargin);
  EXPECT_FALSE(round.near(Vec3::Zero()).nothing());
  const TriangleMesh flat{{{10, 0, 0}, {20, 0, 0}, {10, 1, 0}}, {{0, 1, 2}}};
  EXPECT_TRUE(NearFaces(flat, kMargin).near({1, 0.02, 0}).nothing());
}

TEST(NearFaces, EdgesOfTheRimAreFoundNearTheDirectionsThatAskForThem) {
  const TriangleMesh socket = make_ball_socket_pair(1200).socket;
  const NearFaces faces(socket, kMargin);
  ASSERT_FALSE(faces.jumps().empty());
  for (const JumpEdge& edge : faces.jumps()) {
    const std::vector<Vec3> there{
        beside(socket.vertices[edge.from].normalized(), Vec3(0.1, 0.2, -0.9), 0.9 * kMargin)};
    bool found = false;
    for (const JumpEdge& near : faces.jumps_near(there, kMargin))
      found = found || (near.from == edge.from && near.to == edge.to);
    EXPECT_TRUE(found);
  }
  EXPECT_TRUE(faces.jumps_near(std::vector<Vec3>{Vec3::UnitZ()}, kMargin).empty())
      << "the rim is a quarter turn away";
}

}  // namespace
}  // namespace impinge
