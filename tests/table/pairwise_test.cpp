// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle against closed forms: r(u) of an octahedron, a cone and the planes of any convex body; no ray
// slips through a closed surface, wherever it is aimed.
#include "table/pairwise.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"

namespace impinge {
namespace {

TEST(Pairwise, MeetsTheClosedForms) {
  const RayCaster octa(octahedron(20.0));
  const RayCaster pyramid(cone());
  for (const Vec3& u : test::random_directions(20000, 20)) {
    EXPECT_NEAR(octa.cast(u, Layer::farthest), octahedron_mesh_radius(u, 20.0), 1e-12 * 20.0);
    EXPECT_NEAR(pyramid.cast(u, Layer::nearest), cone_mesh_radius(u), 1e-11 * 20.0);
  }
}

// Rays through vertices, edges, poles and axes, where strict inside tests leak.
TEST(Pairwise, NoRaySlipsThroughAClosedSurface) {
  const Vec3 aside(3.0, -2.0, 5.0);
  for (const TriangleMesh& body : {octahedron(20.0), cone(), sphere(22.0, 300, aside),
                                   sphere(22.0, 1000, aside), make_ball_socket_pair(1000).ball}) {
    const RayCaster caster(body);
    auto directions = test::feature_directions(body);
    for (const Vec3& x : test::special_directions()) directions.push_back(x.normalized());
    for (const Vec3& u : directions) {
      const double near = caster.cast(u, Layer::nearest);
      const double far = caster.cast(u, Layer::farthest);
      ASSERT_FALSE(std::isnan(near)) << u.transpose();
      ASSERT_NEAR(near, far, 1e-12 * far) << "two faces of one edge agree";
    }
  }
}

TEST(Pairwise, KeepsTheLayerAskedFor) {
  const TriangleMesh inner = sphere(20.0, 500);
  const TriangleMesh outer = sphere(25.0, 500);
  const RayCaster both(test::joined(inner, outer));
  const RayCaster inner_only(inner);
  const RayCaster outer_only(outer);
  for (const Vec3& u : test::random_directions(500, 21)) {
    EXPECT_EQ(both.cast(u, Layer::nearest), inner_only.cast(u, Layer::nearest));
    EXPECT_EQ(both.cast(u, Layer::farthest), outer_only.cast(u, Layer::nearest));
  }
}

TEST(Pairwise, ACupIsMetInsideItsRimOnly) {
  const double opening = 60.0 * kDegree;
  const RayCaster caster(cup(26.0, 60.0, 2000));
  for (const Vec3& u : test::random_directions(5000, 22)) {
    const double phi = to_angles(u).phi;
    if (std::abs(phi - opening) < 0.01) continue;  // the rim is a polygon
    EXPECT_EQ(std::isnan(caster.cast(u, Layer::nearest)), phi > opening);
  }
}

TEST(Pairwise, EdgeOnAndDegenerateFacesAreNotMet) {
  TriangleMesh mesh = octahedron(20.0);
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{5, 0, 0}, {10, 0, 0}, {7, 1e-3, 0}, {0, 0, 0}});
  mesh.faces.push_back({first, first + 1, first + 2});  // its plane z = 0 holds the centre
  mesh.faces.push_back({first, first, first + 1});
  mesh.faces.push_back({first + 3, first + 1, first + 2});  // a corner at the centre
  const RayCaster caster(mesh);
  for (const Vec3& u : test::feature_directions(mesh)) {
    if (u.norm() == 0.0) continue;  // the corner at the centre has no direction
    EXPECT_NEAR(caster.cast(u, Layer::nearest), octahedron_mesh_radius(u, 20.0), 1e-12 * 20.0);
  }
}

}  // namespace
}  // namespace impinge
