// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: a table of rounded numbers has every rim cell that one in double has, that included whose edge is
// only just within what the slope allows:
//   marked by mask_rim() of the table in double => marked by fill_cube(), in float and in 16 bits
#include "table/fill/cube_rim.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"
#include "table/exact_raster.hpp"
#include "table/fill/cube_fill.hpp"

namespace impinge {
namespace {

constexpr double kDivisions = 8.0;   // of the cube
const Vec3 kPlate(0.12, 0.14, 1.0);  // in the middle of a cell

// A plate smaller than a cell, so far from the centre (mm), and an octahedron that lies any way.
TriangleMesh with_plate(const Vec3& turn, double depth) {
  TriangleMesh mesh = test::turned(octahedron(20.0), 1.0, turn);
  test::add_face(mesh, depth * kPlate, depth * (kPlate + Vec3(0.03, 0.0, 0.0)),
                 depth * (kPlate + Vec3(0.0, 0.03, 0.0)));
  return mesh;
}

bool marked_in_double(const TriangleMesh& mesh, const CubeGnomonic& scheme, Layer layer) {
  return fill_exact(mesh, scheme, layer).is_rim_cell(scheme.stencil(kPlate).cell);
}

template <class Value>
bool marked_by_kernel(const TriangleMesh& mesh, const CubeGnomonic& scheme, Layer layer) {
  PackedTable<CubeGnomonic, Value> table;
  fill_cube(mesh, {scheme, layer, 1}, table);
  const std::size_t cell = scheme.stencil(kPlate).entry[0];
  return !table.none.empty() && (table.none[cell / 32] >> (cell % 32) & 1U) != 0U;
}

// Bisects for the last depth at which the plate is seen; `hidden` is one at which it is not.
void expect_marked_at_the_last_depth(const Vec3& turn, Layer layer, double seen, double hidden) {
  const CubeGnomonic scheme = CubeGnomonic::with_precision(90.0 / kDivisions);
  ASSERT_TRUE(marked_in_double(with_plate(turn, seen), scheme, layer));
  ASSERT_FALSE(marked_in_double(with_plate(turn, hidden), scheme, layer));
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (seen + hidden);
    (marked_in_double(with_plate(turn, middle), scheme, layer) ? seen : hidden) = middle;
  }
  const TriangleMesh last = with_plate(turn, seen);
  EXPECT_TRUE(marked_by_kernel<float>(last, scheme, layer)) << turn.transpose();
  EXPECT_TRUE(marked_by_kernel<std::uint16_t>(last, scheme, layer)) << turn.transpose();
}

TEST(CubeRim, RoundingLeavesOutNoCellThatIsOnlyJustOfTheRim) {
  for (const Vec3& turn : test::random_directions(8, 70)) {
    expect_marked_at_the_last_depth(turn, Layer::nearest, 12.0, 200.0);
    expect_marked_at_the_last_depth(turn, Layer::farthest, 20.0, 1.0);
  }
}

}  // namespace
}  // namespace impinge
