// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/latitude_rows.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"
#include "table/partial_table.hpp"

namespace impinge {
namespace {

// fill_exact() = fill_pairwise() at every entry, for every scheme: the same entries have a surface, and the
// radii agree within 1e-9 r (they differ by rounding only; 1e-12 r is what is met).

constexpr double kRelative = 1e-9;

// Of the gate's optimised build on; coarser where sanitizers make brute force ten times slower.
double fine() { return random_cases() >= 10'000 ? 1.0 : 2.0; }

void expect_same_everywhere(const TriangleMesh& mesh, double precision, Layer layer) {
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(precision);
    const auto oracle = fill_pairwise(mesh, scheme, layer);
    const auto table = fill_exact(mesh, scheme, layer);
    for (std::size_t i = 0; i < scheme.size(); ++i) {
      const double expected = oracle.radii()[i];
      const double found = table.radii()[i];
      ASSERT_EQ(std::isnan(found), std::isnan(expected)) << S::name << " entry " << i;
      if (!std::isnan(expected)) {
        ASSERT_NEAR(found, expected, kRelative * expected) << S::name << " entry " << i;
      }
    }
    for (std::size_t cell = 0; cell < scheme.cells(); ++cell) {
      ASSERT_EQ(table.is_rim_cell(cell), oracle.is_rim_cell(cell));
    }
  });
}

Eigen::Matrix3d some_rotation() {
  return (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
}

// Edges along phi = 90 degrees and theta = 0, 90, 180, 270, that is on grid lines; corners on entries, the
// poles among them.
TEST(ExactRaster, EdgesOnGridLinesAndCornersOnEntries) {
  expect_same_everywhere(octahedron(20.0), 1.0, Layer::farthest);
  expect_same_everywhere(octahedron(20.0), 7.5, Layer::farthest);
}

TEST(ExactRaster, PoleInsideAFace) {
  expect_same_everywhere(test::turned(octahedron(20.0), some_rotation()), 2.0, Layer::farthest);
}

TEST(ExactRaster, PoleOnAnEdge) {
  const Eigen::Matrix3d eighth = Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitX()).toRotationMatrix();
  TriangleMesh mesh = test::turned(octahedron(20.0), eighth);
  for (Vec3& v : mesh.vertices) {
    if (std::abs(v.x()) < 1e-12) v.x() = 0.0;  // the edges over the poles lie in the plane x = 0 exactly
  }
  expect_same_everywhere(mesh, 2.0, Layer::farthest);
}

TEST(ExactRaster, GeneratedJoint) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  expect_same_everywhere(pair.ball, fine(), Layer::farthest);
  expect_same_everywhere(pair.socket, fine(), Layer::nearest);
  expect_same_everywhere(test::turned(pair.socket, some_rotation()), fine(), Layer::nearest);
}

TEST(ExactRaster, OffCentreBodyAndCone) {
  expect_same_everywhere(sphere(22.0, 500, {15.0, 5.0, -8.0}), 2.0, Layer::farthest);
  expect_same_everywhere(cone(), 2.0, Layer::farthest);
}

TEST(ExactRaster, LayersOfAThickSocket) {
  const TriangleMesh wall = test::joined(cup(26.0, 70.0, 600), test::inside_out(cup(29.0, 75.0, 600)));
  expect_same_everywhere(wall, fine(), Layer::nearest);
  expect_same_everywhere(wall, fine(), Layer::farthest);
}

// The oracle against closed forms: r(u) of an octahedron, a cone and the planes of any convex body; no ray
// slips through a closed surface, wherever it is aimed.

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

// A table of the entries that are read answers as the table of all of them, bit for bit:
//   partial.radius_at(x) == full.radius_at(x) for every x whose taps were inserted

constexpr double kPrecision = 3.0;  // degrees

PartialTable partial_of(const TriangleMesh& mesh, const AnyScheme& scheme, const std::vector<Vec3>& asked,
                        Layer layer) {
  EntrySet entries(scheme.size());
  for (const Vec3& x : asked) insert_taps(scheme, x, entries);
  entries.number();
  const NearFaces faces(mesh, scheme.stencil_radius());
  return fill_partial(faces, scheme, std::move(entries), layer);
}

template <class S>
class PartialTableOf : public ::testing::Test {
 protected:
  // Returns how many answers a rim has taken.
  static std::size_t expect_same(const TriangleMesh& mesh, const std::vector<Vec3>& asked, Layer layer) {
    const S scheme = S::with_precision(kPrecision);
    const RadialTable<S> full = fill_exact(mesh, scheme, layer);
    const PartialTable partial = partial_of(mesh, AnyScheme(S::name, kPrecision), asked, layer);
    std::size_t at_a_rim = 0;
    for (const Vec3& x : asked) {
      const double expected = full.radius_at(x);
      const double found = partial.radius_at(x);
      EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected)))
          << x.transpose() << ": " << found << " against " << expected;
      at_a_rim += full.is_rim_cell(scheme.stencil(x).cell) ? 1U : 0U;
    }
    EXPECT_LT(partial.kept().count(), scheme.size());
    return at_a_rim;
  }
};
using Schemes = ::testing::Types<Rsid, IcosahedralGnomonic, LatitudeRows>;
TYPED_TEST_SUITE(PartialTableOf, Schemes);

TYPED_TEST(PartialTableOf, AnswersAsTheFullTableOfASocket) {
  const TriangleMesh socket = make_ball_socket_pair(800).socket;
  std::vector<Vec3> asked = test::random_directions(150, 7);
  for (std::size_t v = 0; v < socket.vertices.size(); v += 3) asked.push_back(socket.vertices[v]);
  EXPECT_GT(this->expect_same(socket, asked, Layer::nearest), 0U) << "the rim is met";
}

TYPED_TEST(PartialTableOf, AnswersAsTheFullTableOfAClosedBall) {
  EXPECT_EQ(
      this->expect_same(make_ball_socket_pair(800).ball, test::random_directions(150, 8), Layer::farthest),
      0U);
}

// Folds, jumps and steep faces all over the place.
TYPED_TEST(PartialTableOf, AnswersAsTheFullTableOfFacesAtRandom) {
  EXPECT_GT(this->expect_same(test::soup(60, 9), test::random_directions(200, 10), Layer::nearest), 0U);
}

TEST(PartialTable, WhatIsNotKeptHasNoAnswer) {
  const TriangleMesh ball = make_ball_socket_pair(800).ball;
  const AnyScheme scheme("rsid", kPrecision);
  const PartialTable partial = partial_of(ball, scheme, {Vec3(0.3, 0.4, 0.8)}, Layer::farthest);
  EXPECT_EQ(partial.kept().count(), 4U);
  EXPECT_FALSE(std::isnan(partial.radius_at({0.3, 0.4, 0.8})));
  EXPECT_TRUE(std::isnan(partial.radius_at({-0.3, 0.4, 0.8})));
}

}  // namespace
}  // namespace impinge
