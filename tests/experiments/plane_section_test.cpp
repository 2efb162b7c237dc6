// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: every end of a segment lies on the plane, n.x = 0, and on an edge of the mesh; the section of a
// closed body is closed; that of an octahedron is the square |x| + |z| = R.
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "19_slices_to_surface/isosurface.hpp"
#include "23_detection_diagrams/diagram_tables.hpp"
#include "imaging/ct_scan.hpp"
#include "mesh/bodies.hpp"
#include "mesh/validation.hpp"

namespace impinge::lab {
namespace {

double length(const Segment& s) { return (s[1] - s[0]).norm(); }

TEST(PlaneSection, ClosedBodyGivesAClosedLine) {
  const TriangleMesh body = sphere(20.0, 2000, Vec3(3.0, -2.0, 5.0));
  const Vec3 normal(0.3, -0.5, 2.0);
  const std::vector<Segment> section = plane_section(body, normal);
  std::map<std::tuple<double, double, double>, int> ends;
  double around = 0.0;
  for (const Segment& s : section) {
    around += length(s);
    for (const Vec3& x : s) {
      EXPECT_NEAR(normal.dot(x), 0.0, 1e-13);
      ++ends[{x.x(), x.y(), x.z()}];  // bit for bit: both faces of an edge find the same point
    }
  }
  for (const auto& end : ends) EXPECT_EQ(end.second, 2);
  // A circle of radius sqrt(R^2 - h^2), h the distance of the sphere's centre from the plane.
  const double h = normal.dot(Vec3(3.0, -2.0, 5.0)) / normal.norm();
  const double circle = 2.0 * kPi * std::sqrt(20.0 * 20.0 - h * h);
  EXPECT_LT(around, circle);
  EXPECT_GT(around, 0.99 * circle);
}

// The plane y = 0 holds four corners of the octahedron.
TEST(PlaneSection, CornersOnThePlaneGiveTheSquareOnce) {
  double around = 0.0;
  for (const Segment& s : plane_section(octahedron(7.0), Vec3::UnitY())) {
    around += length(s);
    for (const Vec3& x : s) EXPECT_NEAR(std::abs(x.x()) + std::abs(x.z()), 7.0, 1e-14);
  }
  EXPECT_NEAR(around, 4.0 * std::sqrt(2.0) * 7.0, 1e-13);
}

TEST(PlaneSection, IsEmptyWhereNothingCrosses) {
  EXPECT_TRUE(plane_section(sphere(2.0, 200, Vec3(0.0, 5.0, 0.0)), Vec3::UnitY()).empty());
  EXPECT_TRUE(plane_section(sphere(2.0, 200, Vec3(0.0, -5.0, 0.0)), Vec3::UnitY()).empty());
}

// Contract: on an image linear in the coordinates the surface is the plane itself; on that of a sphere it is
// closed, has outward normals and lies within a fraction of a voxel of it.

TEST(Isosurface, OfALinearImageIsAPlane) {
  VoxelImage image{{5, 6, 7}, Vec3(0.5, 1.0, 2.0), Vec3(1.0, -2.0, 3.0), {}};
  const Vec3 slope(1.0, 0.5, -0.25);
  image.values.resize(image.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const Vec3 at(static_cast<double>(i % 5), static_cast<double>(i / 5 % 6), static_cast<double>(i / 30));
    image.values[i] = static_cast<float>(slope.dot(image.origin + at.cwiseProduct(image.spacing)));
  }
  const TriangleMesh plane = isosurface(image, 0.6);
  ASSERT_GT(plane.faces.size(), 10U);
  for (const Vec3& v : plane.vertices) EXPECT_NEAR(slope.dot(v), 0.6, 1e-5);
  for (const Face& f : plane.faces)
    EXPECT_LE(slope.dot(area_vector(plane, f)), 0.0) << "towards smaller values";
  image.values.pop_back();
  EXPECT_THROW(isosurface(image, 0.6), std::invalid_argument);
}

TEST(Isosurface, OfAScannedSphereIsTheSphere) {
  const TriangleMesh body = sphere(8.0, 2000);
  const VoxelImage shares = bone_shares(body, {0.7, 1.25, 2.0});
  const TriangleMesh surface = isosurface(hounsfield(shares, {50.0, 850.0, 0.0, 0}), 450.0);
  const MeshReport report = validate(surface);
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.components, 1U);
  EXPECT_GT(report.volume.value_or(0.0), 0.0) << "outward";
  for (const Vec3& v : surface.vertices) EXPECT_NEAR(v.norm(), 8.0, 0.25);
}

TEST(Decimate, KeepsAClosedSurfaceNearWithFewerFaces) {
  const TriangleMesh body = sphere(8.0, 4000);
  const TriangleMesh fewer = decimate(body, 500);
  EXPECT_LE(fewer.faces.size(), 500U);
  EXPECT_GT(fewer.faces.size(), 400U);
  EXPECT_TRUE(validate(fewer).closed());
  for (const Vec3& v : fewer.vertices) EXPECT_NEAR(v.norm(), 8.0, 0.2);
  EXPECT_EQ(decimate(body, 4000).faces, body.faces);
}

}  // namespace
}  // namespace impinge::lab
