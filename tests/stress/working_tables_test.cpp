// SPDX-License-Identifier: GPL-3.0-or-later
// Look-ups of tables that are worked out where they are read are those of whole tables, and within bounds.
#include "stress/working_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/stored_table.hpp"
#include "support/directions.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

const WorkingTable& of(const std::vector<WorkingTable>& tables, const std::string& name, double precision) {
  return *std::ranges::find_if(tables, [&](const WorkingTable& table) {
    return table.name == name && std::abs(table.precision_deg - precision) < 1e-9;
  });
}

TEST(WorkingTables, AnswerAsWholeTablesDo) {
  const TriangleMesh mesh = cup(22.0, 70.0, 300);
  const std::vector<Vec3> directions = test::random_directions(200, 4);
  const std::vector<WorkingTable> tables = working_tables(mesh, directions);
  const RadialTable<Rsid> rsid = fill_exact(mesh, Rsid::with_precision(1.0), Layer::nearest);
  const RadialTable<CubeGnomonic> cube = fill_exact(mesh, CubeGnomonic::with_precision(1.0), Layer::nearest);
  const InverseDepthTable<CubeGnomonic> inverse(cube);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double whole = rsid.radius_at(directions[i]);
    const double here = of(tables, "rsid", 1.0).answers[i];
    EXPECT_EQ(std::isnan(whole), std::isnan(here)) << i;
    if (!std::isnan(whole)) {
      EXPECT_NEAR(here, whole, 1e-14 * whole);
    }
    const double flat = of(tables, "cube_gnomonic_mesh_exact", 1.0).answers[i];
    if (!std::isnan(flat)) {
      EXPECT_NEAR(flat, inverse.radius_at(directions[i]), 1e-13 * flat);
    }
  }
}

TEST(WorkingTables, KeepTheirBounds) {
  const TriangleMesh mesh = sphere(22.0, 300, {6.0, -4.0, 3.0});
  const std::vector<Vec3> directions = test::random_directions(200, 5);
  const std::vector<double> truth = exact_radii(mesh, {directions, Layer::nearest, {}});
  std::size_t close = 0;
  for (const WorkingTable& table : working_tables(mesh, directions)) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double error = std::abs(table.answers[i] - truth[i]);
      EXPECT_LE(error, table.bounds[i]) << table.name;
      close += error > 0.05 * table.bounds[i] ? 1U : 0U;
    }
  }
  EXPECT_GT(close, 10U) << "a bound a twentieth as large would not be kept";
}

// The centre is 2 um from a corner: faces are seen over half of the sphere, and their sizes say nothing.
TEST(WorkingTables, KeepTheirBoundsWhereTheCentreIsNearTheSurface) {
  TriangleMesh mesh = icosphere(22.0, 1);
  const Vec3 corner = mesh.vertices[7];
  for (Vec3& x : mesh.vertices) x -= 0.9999 * corner;
  std::vector<Vec3> directions;
  for (const Vec3& aside : test::random_directions(200, 6))
    directions.push_back((corner.normalized() + 0.3 * aside).normalized());
  const std::vector<double> truth = exact_radii(mesh, {directions, Layer::nearest, {}});
  for (const WorkingTable& table : working_tables(mesh, directions)) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (std::isnan(table.answers[i])) continue;
      EXPECT_LE(std::abs(table.answers[i] - truth[i]), table.bounds[i]) << table.name;
    }
  }
}

}  // namespace
}  // namespace impinge::lab
