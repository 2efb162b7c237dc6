// SPDX-License-Identifier: GPL-3.0-or-later
// Contract of the generated bodies, n the outward normal and v0 a corner of any face:
//   a closed body has exactly the faces asked for, F / 2 + 2 vertices, and n.v0 > 0;
//   vertices lie on the smooth surface: |v| = r(v / |v|); angles of all faces are at least 28 degrees;
//   octahedron: r(u) = R / |u|_1; cone: r(u) = min d / (n.u); eccentric sphere: |r(u) u - e| = R.
#include "mesh/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/rings.hpp"
#include "mesh/validation.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

struct Quality {
  double smallest_angle = kPi;
  double longest_over_median = 0.0;
  double smallest_outward = 1e300;  // n.v0 / |v0|, n a unit normal
};

Quality quality(const TriangleMesh& mesh) {
  Quality quality;
  std::vector<double> lengths;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = corner(mesh, face, k);
      const Vec3 ab = corner(mesh, face, (k + 1) % 3) - a;
      const Vec3 ac = corner(mesh, face, (k + 2) % 3) - a;
      quality.smallest_angle = std::min(quality.smallest_angle, angle_between(ab, ac));
      lengths.push_back(ab.norm());
    }
    const double outward = area_vector(mesh, face).normalized().dot(corner(mesh, face, 0).normalized());
    quality.smallest_outward = std::min(quality.smallest_outward, outward);
  }
  std::ranges::sort(lengths);
  quality.longest_over_median = lengths.back() / lengths[lengths.size() / 2];
  return quality;
}

// Distance from the origin to the mesh along u, by brute force: all faces, each corner on its side.
double mesh_radius(const TriangleMesh& mesh, const Vec3& u) {
  double radius = std::nan("");
  for (const Face& face : mesh.faces) {
    const Vec3& a = corner(mesh, face, 0);
    const Vec3& b = corner(mesh, face, 1);
    const Vec3& c = corner(mesh, face, 2);
    const double slack = -1e-12;
    if (u.dot(a.cross(b)) < slack || u.dot(b.cross(c)) < slack || u.dot(c.cross(a)) < slack) continue;
    const Vec3 n = area_vector(mesh, face);
    radius = n.dot(a) / n.dot(u);
  }
  return radius;
}

TEST(UnitSphere, AnyEvenCountIsAClosedStarShapedSphere) {
  for (std::size_t faces = 8; faces <= 400; faces += 2) {
    const TriangleMesh mesh = unit_sphere(faces);
    const MeshReport report = validate(mesh);
    ASSERT_EQ(report.faces, faces);
    EXPECT_EQ(report.vertices, faces / 2 + 2);
    EXPECT_TRUE(report.closed() && report.volume && *report.volume > 0.0) << faces;
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.unreferenced_vertices + report.degenerate_faces + report.duplicate_faces, 0U);
    EXPECT_GT(quality(mesh).smallest_outward, 0.5) << faces;
  }
}

TEST(UnitSphere, FacesAreNearlyEquilateral) {
  for (const std::size_t faces : {8U, 14U, 20U, 50U, 300U, 684U, 1000U, 3000U, 12000U, 100000U}) {
    const Quality q = quality(unit_sphere(faces));
    EXPECT_GT(q.smallest_angle, 28.0 * kDegree) << faces;
    EXPECT_LT(q.longest_over_median, 1.5) << faces;
  }
}

TEST(UnitSphere, VolumeApproachesTheSphereLikeOneOverTheFaces) {
  const double exact = 4.0 / 3.0 * kPi;
  double last = 0.0;
  for (const std::size_t faces : {300U, 3000U, 30000U}) {
    const double deficit = (exact - *validate(unit_sphere(faces)).volume) * static_cast<double>(faces);
    EXPECT_GT(deficit, 0.0);  // inscribed
    if (last > 0.0) {
      EXPECT_NEAR(deficit / last, 1.0, 0.05);
    }
    last = deficit;
  }
}

TEST(UnitSphere, EightFacesAreTheOctahedron) {
  const TriangleMesh mesh = unit_sphere(8);
  for (const Vec3& v : mesh.vertices) EXPECT_EQ(v.lpNorm<1>(), 1.0);
  EXPECT_EQ(validate(mesh).volume, 4.0 / 3.0);
}

TEST(UnitSphere, OtherCountsAreRefused) {
  for (const std::size_t faces : {0U, 2U, 6U, 7U, 9U, 301U}) {
    EXPECT_THROW(unit_sphere(faces), std::invalid_argument) << faces;
  }
}

TEST(UnitCap, AnyCountIsOneOpenDisk) {
  for (const double opening : {10.0, 60.0, 87.0, 90.0, 120.0, 170.0}) {
    for (std::size_t faces = 3; faces <= 300; ++faces) {
      const TriangleMesh mesh = unit_cap(faces, opening * kDegree);
      const MeshReport report = validate(mesh);
      ASSERT_EQ(report.faces, faces) << opening;
      // A disk: V - E + F = 1 with 3 F = 2 E - boundary.
      EXPECT_EQ(2 * report.vertices, faces + report.boundary_edges + 2) << opening << ' ' << faces;
      EXPECT_EQ(report.components, 1U);
      EXPECT_EQ(report.non_manifold_edges + report.flipped_faces + report.unreferenced_vertices, 0U);
      EXPECT_GT(quality(mesh).smallest_outward, 0.0) << opening << ' ' << faces;
    }
  }
}

TEST(UnitCap, OtherSizesAreRefused) {
  EXPECT_THROW(unit_cap(2, 1.0), std::invalid_argument);
  EXPECT_THROW(unit_cap(100, 0.0), std::invalid_argument);
  EXPECT_THROW(unit_cap(100, kPi), std::invalid_argument);
  EXPECT_THROW(unit_cap(100, std::nan("")), std::invalid_argument);
}

TEST(Sphere, VerticesLieOnItWhereverItIs) {
  const Vec3 centre(3.0, -2.0, 1.0);
  for (const Vec3& v : sphere(22.0, 1000, centre).vertices) EXPECT_NEAR((v - centre).norm(), 22.0, 1e-13);
}

TEST(Sphere, EccentricRadiusIsWhereTheRayLeavesTheSphere) {
  const Vec3 centre(3.0, -2.0, 1.0);
  for (const Vec3& u : test::random_directions(200, 7)) {
    const double r = eccentric_sphere_radius(u, 22.0, centre);
    EXPECT_GT(r, 0.0);
    EXPECT_NEAR((r * u - centre).norm(), 22.0, 1e-13);
  }
  EXPECT_EQ(eccentric_sphere_radius({0, 0, 1}, 5.0, {0, 0, 2}), 7.0);
  EXPECT_EQ(eccentric_sphere_radius({0, 0, -1}, 5.0, {0, 0, 2}), 3.0);
}

TEST(RadialBody, VerticesAreAtTheirRadius) {
  const auto radius = [](const Vec3& u) { return 10.0 + u.x() - 2.0 * u.z() * u.z(); };
  for (const Vec3& v : radial_body(500, radius).vertices)
    EXPECT_NEAR(v.norm(), radius(v.normalized()), 1e-13);
}

TEST(Octahedron, MeshRadiusIsExact) {
  const TriangleMesh mesh = octahedron(25.0);
  EXPECT_EQ(validate(mesh).volume, 4.0 / 3.0 * 25.0 * 25.0 * 25.0);
  for (const Vec3& u : test::random_directions(200, 7)) {
    EXPECT_NEAR(octahedron_mesh_radius(u, 25.0), mesh_radius(mesh, u), 1e-12);
  }
}

TEST(Cone, MeshRadiusIsExact) {
  for (const std::size_t sides : {3U, 4U, 64U}) {
    const ConeShape shape{12.0, 30.0, 7.0, sides};
    const TriangleMesh mesh = cone(shape);
    EXPECT_EQ(mesh.faces.size(), 2 * sides);
    for (const Vec3& u : test::random_directions(200, 7)) {
      const double r = mesh_radius(mesh, u);
      EXPECT_NEAR(cone_mesh_radius(u, shape), r, 1e-12 * r);
    }
  }
}

// Volume of the pyramid: base area n/2 a^2 sin(2 pi / n), times height / 3.
TEST(Cone, IsClosedAndHasItsVolume) {
  const ConeShape shape;
  const MeshReport report = validate(cone(shape));
  const auto n = static_cast<double>(shape.sides);
  const double base = 0.5 * n * shape.base_radius * shape.base_radius * std::sin(2.0 * kPi / n);
  ASSERT_TRUE(report.closed() && report.volume);
  EXPECT_NEAR(*report.volume, base * (shape.apex_height + shape.base_depth) / 3.0, 1e-9);
}

TEST(Cone, ImpossibleShapesAreRefused) {
  EXPECT_THROW(cone({20.0, 30.0, 10.0, 2}), std::invalid_argument);
  EXPECT_THROW(cone({0.0, 30.0, 10.0, 8}), std::invalid_argument);
  EXPECT_THROW(cone({20.0, -1.0, 10.0, 8}), std::invalid_argument);
  EXPECT_THROW(cone({20.0, 30.0, std::nan(""), 8}), std::invalid_argument);
  EXPECT_THROW(octahedron(0.0), std::invalid_argument);
  EXPECT_THROW(sphere(-1.0, 8), std::invalid_argument);
  EXPECT_THROW(cup(HUGE_VAL, 87.0, 100), std::invalid_argument);
}

TEST(Cup, FacesTheCentreAndEndsAtItsRim) {
  const TriangleMesh mesh = cup(26.0, 87.0, 1001);
  EXPECT_EQ(mesh.faces.size(), 1001U);
  EXPECT_EQ(mesh.vertices[0], Vec3(0.0, 0.0, 26.0));
  for (const Vec3& v : mesh.vertices) EXPECT_NEAR(v.norm(), 26.0, 1e-13);
  for (const Face& face : mesh.faces) EXPECT_LT(area_vector(mesh, face).dot(corner(mesh, face, 0)), 0.0);
  const std::vector<Edge> rim = boundary_edges(mesh);
  EXPECT_GT(rim.size(), 10U);
  for (const auto& [a, b] : rim) {
    EXPECT_NEAR(to_angles(mesh.vertices[a]).phi, 87.0 * kDegree, 1e-14);
    // Surface to the left seen from inside: the rim runs clockwise about +z.
    EXPECT_LT(mesh.vertices[a].cross(mesh.vertices[b]).z(), 0.0);
  }
}

}  // namespace
}  // namespace impinge
