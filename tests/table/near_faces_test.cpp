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
#include "table/probe_directions.hpp"

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
        const double bound = faces.radius_bound(u, layer);
        EXPECT_TRUE(layer == Layer::nearest ? bound <= radius : bound >= radius) << bound << " " << radius;
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

// Each of equal boxes in (z, theta), which have equal areas, gets its share.
TEST(ProbeDirections, UniformOnesFillEqualAreasEqually) {
  constexpr std::size_t count = 64000;
  std::array<std::size_t, 64> boxes{};
  for (const Vec3& u : uniform_directions(count, 3)) {
    ASSERT_NEAR(u.norm(), 1.0, 4e-16);
    const auto row = std::min<std::size_t>(static_cast<std::size_t>(4.0 * (1.0 + u.z())), 7);
    const auto column = static_cast<std::size_t>(4.0 * to_angles(u).theta / kPi);
    ++boxes[8 * row + column];
  }
  // 1000 expected, with a standard deviation of 31.
  for (const std::size_t box : boxes) EXPECT_NEAR(static_cast<double>(box), 1000.0, 160.0);
}

TEST(ProbeDirections, TheSeedDecides) {
  EXPECT_EQ(uniform_directions(100, 1), uniform_directions(100, 1));
  EXPECT_NE(uniform_directions(100, 1), uniform_directions(100, 2));
  // The generator's own numbers, not those of a distribution: the same with every standard library.
  EXPECT_NEAR(uniform_directions(1, 5489)[0].z(), 2.0 * 0.786820954867802 - 1.0, 1e-12);
}

TEST(ProbeDirections, FeaturesAreAllVerticesAndEdges) {
  const TriangleMesh mesh = sphere(22.0, 200, {3.0, -1.0, 2.0});
  const auto features = feature_directions(mesh);
  ASSERT_EQ(features.size(), mesh.vertices.size() + 300);  // 3/2 edges a face of a closed mesh
  std::size_t found = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 middle = (corner(mesh, face, 0) + corner(mesh, face, 1)).normalized();
    found +=
        std::ranges::any_of(features, [&](const Vec3& u) { return (u - middle).norm() < 1e-15; }) ? 1U : 0U;
  }
  EXPECT_EQ(found, mesh.faces.size());
}

TEST(ProbeDirections, PolarOnesFillBothCapsEqually) {
  constexpr double within = 0.05;
  const auto directions = polar_directions(within, 2000);
  std::size_t north = 0;
  std::size_t inner = 0;  // the half of the area next to a pole
  for (const Vec3& u : directions) {
    const double phi = std::acos(std::abs(u.z()));
    ASSERT_LT(phi, within);
    north += u.z() > 0.0 ? 1U : 0U;
    inner += phi < within / std::sqrt(2.0) ? 1U : 0U;
  }
  EXPECT_EQ(north, 1000U);
  EXPECT_NEAR(static_cast<double>(inner), 1000.0, 5.0);
}

}  // namespace
}  // namespace impinge
