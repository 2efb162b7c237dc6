// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: what the diagrams show is what the library computes. The weights of an excerpt give the radius of
// the look-up; concentric spheres have the gap R - r at every vertex; a pixel is an entry.
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "23_detection_diagrams/diagram_bodies.hpp"
#include "23_detection_diagrams/diagram_lookup.hpp"
#include "23_detection_diagrams/diagram_tables.hpp"
#include "23_sampling_diagrams/table_image.hpp"
#include "mesh/bodies.hpp"
#include "methods/chart_coverage.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

double cell(const Table& table, std::size_t row, std::size_t column) {
  return std::stod(table.rows[row][column].text());
}

TEST(Diagrams, ExcerptGivesTheRadiusOfTheLookUp) {
  const RadialTable<Rsid> socket =
      fill_exact(sphere(26.0, 400, Vec3(2.0, 1.0, 3.0)), Rsid::with_precision(1.0), Layer::nearest);
  for (const Vec3& x : {Vec3(8.0, -0.02, 20.0), Vec3(-9.0, 4.0, -3.0), Vec3(0.01, 0.02, 22.0)}) {
    Table lookups = lookup_table();
    Table excerpt = excerpt_table();
    add_lookup({"p", 7, x}, socket, lookups);
    add_excerpt({"p", 7, x}, socket, excerpt);
    double weights = 0.0;
    double radius = 0.0;
    for (std::size_t i = 0; i < excerpt.rows.size(); ++i) {
      weights += cell(excerpt, i, 6);
      radius += cell(excerpt, i, 6) * cell(excerpt, i, 5);
    }
    EXPECT_NEAR(weights, 1.0, 1e-14);
    EXPECT_NEAR(radius, cell(lookups, 0, 8), 1e-12);
    EXPECT_NEAR(cell(lookups, 0, 9), cell(lookups, 0, 8) - x.norm(), 1e-12);
  }
}

TEST(Diagrams, ScansOfConcentricSpheres) {
  Table scans = scan_table();
  const Pose closer{Eigen::Matrix3d::Identity(), Vec3(0.0, 0.0, 5.0)};
  const TriangleMesh ball = sphere(22.0, 2000);
  const TriangleMesh socket = sphere(26.0, 2000);
  add_scans(ball, socket, {}, Rsid::with_precision(1.0), scans);
  add_scans(ball, socket, closer, Rsid::with_precision(1.0), scans);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(cell(scans, i, 6), cell(scans, i, 2));  // every vertex faces the other surface
    EXPECT_EQ(cell(scans, i, 7), 0.0);
    EXPECT_NEAR(cell(scans, i, 8), 4.0, 0.05);
    EXPECT_GT(cell(scans, i + 2, 7), 0.0);
    EXPECT_NEAR(cell(scans, i + 2, 8), -1.0, 0.05);  // 5 mm towards the pole of a gap of 4 mm
  }
}

TEST(Diagrams, EdgeOverThePoleIsExact) {
  const TriangleMesh moved = over_an_edge(sphere(22.0, 400, Vec3(0.4, 0.3, 0.0)));
  const TriangleMesh held = faces_along(moved, Vec3::UnitZ());
  ASSERT_EQ(held.faces.size(), 2U);
  EXPECT_THROW(over_an_edge(sphere(2.0, 400, Vec3(9.0, 0.0, 0.0))), std::invalid_argument);
}

TEST(Diagrams, PixelOfTheImageIsAnEntry) {
  RadialTable<Rsid> table(Rsid::with_precision(45.0));
  table.radii()[9] = 20.0;
  table.radii()[10] = 30.0;
  table.radii()[39] = 25.0;
  const GreyRange range = grey_range(table);
  EXPECT_EQ(range.smallest, 20.0);
  EXPECT_EQ(range.largest, 30.0);
  const std::string image = table_image(table, range);
  const std::string header = "P5\n8 5\n255\n";
  ASSERT_EQ(image.size(), header.size() + 40);
  EXPECT_EQ(image.substr(0, header.size()), header);
  const auto pixel = [&](std::size_t i) { return static_cast<unsigned char>(image[header.size() + i]); };
  EXPECT_EQ(pixel(0), 0);
  EXPECT_EQ(pixel(9), 1);
  EXPECT_EQ(pixel(10), 255);
  EXPECT_EQ(pixel(39), 128);
}

TEST(Diagrams, VertexNearestToTheSection) {
  const TriangleMesh body = sphere(22.0, 2000);
  const std::size_t found = vertex_in_section(body, 0.3, 0.5);
  const Vec3& x = body.vertices[found];
  const double phi = to_angles(x).phi;
  EXPECT_TRUE(x.x() > 0.0 && phi >= 0.3 && phi <= 0.5);
  for (const Vec3& v : body.vertices) {
    const double other = to_angles(v).phi;
    if (v.x() > 0.0 && other >= 0.3 && other <= 0.5) {
      EXPECT_LE(std::abs(x.y()), std::abs(v.y()));
    }
  }
  EXPECT_THROW(vertex_in_section(octahedron(3.0), 0.3, 0.5), std::invalid_argument);
}

// A ray each step meets a sphere where its formula says.
TEST(Diagrams, RaysOfASphere) {
  const Vec3 centre(6.0, 0.0, 2.0);
  Table rays = ray_table();
  add_rays("s", sphere(22.0, 2000, centre), 45.0, rays);
  ASSERT_EQ(rays.rows.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3 u = to_direction({cell(rays, i, 1) * kDegree, cell(rays, i, 2) * kDegree});
    EXPECT_NEAR(cell(rays, i, 3), eccentric_sphere_radius(u, 22.0, centre), 0.2);
    EXPECT_NEAR(cell(rays, i, 3), cell(rays, i, 4), 1e-12);
  }
}

// Only the shaft of a hip is met a second time. (Of the two bodies in question: each takes a while.)
TEST(Diagrams, ShaftIsMetTwice) {
  Table bodies = body_table();
  for (const NamedBody& shown : bodies_by_shape({}, 600)) {
    if (shown.name != "femur" && shown.name != "star_shape") continue;
    add_body(shown.name, shown.mesh, bodies);
    Table rays = ray_table();
    add_rays(shown.name, shown.mesh, 5.0, rays);
    bool again = false;
    for (std::size_t i = 0; i < rays.rows.size(); ++i) {
      again = again || cell(rays, i, 4) > cell(rays, i, 3) + 1.0;
    }
    EXPECT_EQ(again, shown.name == "femur") << shown.name;
  }
  ASSERT_EQ(bodies.rows.size(), 2U);
  for (const auto& row : bodies.rows) {
    const bool femur = row[0].text() == "femur";
    EXPECT_EQ(row[4].text(), femur ? "no" : "yes") << row[0].text();
    EXPECT_EQ(std::stod(row[5].text()) > 0.0, femur);
  }
}

}  // namespace
}  // namespace impinge::lab
