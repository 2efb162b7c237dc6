// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a fill right at its limits, one mesh for each guard (kMostThin and kMostTerms of
// tile_triangle.cpp) and for rims that no entry sees: as fill_exact() within 41 u q, u = 2^-24.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "support/joined.hpp"
#include "table/exact_raster.hpp"
#include "table/fill/cube_fill.hpp"

namespace impinge {
namespace {

using FloatCube = PackedTable<CubeGnomonic, float>;

constexpr std::size_t kGuardCells = 64;  // along an edge: two tiles, columns 0 to 32 and 33 to 64

CubeFill guarded_fill(Layer layer) {
  return {CubeGnomonic::with_precision(90.0 / static_cast<double>(kGuardCells)), layer, 1};
}

FloatCube guarded_table(const TriangleMesh& mesh, const CubeFill& fill) {
  FloatCube table;
  fill_cube(mesh, fill, table);
  return table;
}

// A place before the face of the cube about +z, in cells, and its depth in mm.
struct GridPlace {
  double column;
  double row;
  double depth;
};

Vec3 at(const GridPlace& place) {
  const double half = 0.5 * static_cast<double>(kGuardCells);
  return place.depth * Vec3(place.column / half - 1.0, place.row / half - 1.0, 1.0);
}

void add_triangle(const std::array<GridPlace, 3>& corners, TriangleMesh& mesh) {
  test::add_face(mesh, at(corners[0]), at(corners[1]), at(corners[2]));
}

// Returns how many entries have a surface.
std::size_t expect_exact_depths(const TriangleMesh& mesh, Layer layer) {
  const CubeFill fill = guarded_fill(layer);
  const InverseDepthTable<CubeGnomonic> exact(fill_exact(mesh, fill.scheme, layer));
  const FloatCube table = guarded_table(mesh, fill);
  std::size_t filled = 0;
  for (std::size_t e = 0; e < table.values.size(); ++e) {
    const double expected = exact.values()[e];
    const auto found = static_cast<double>(table.values[e]);
    EXPECT_EQ(found == 1.0, std::isnan(expected)) << "entry " << e;  // 1 / mm: no surface
    if (std::isnan(expected)) continue;
    ++filled;
    EXPECT_NEAR(found / expected, 1.0, 41.0 * 0x1p-24) << "entry " << e;
  }
  return filled;
}

// Needles of 1e-9 to 2e-12 cells, from the middle of their short side through three entries. A gradient from
// differences to the far corner is off by 2^-53 times as much as a needle is longer than it is wide.
TEST(FillGuards, NeedlesThroughEntries) {
  TriangleMesh mesh;
  double y = 34.0;
  for (const double width : {1e-9, 1e-10, 3e-11, 1e-11, 4e-12, 2e-12}) {
    double x = 30.0;
    for (const std::array<double, 2>& step : {std::array{5.0, 3.0}, {-3.0, 4.0}, {2.0, -5.0}}) {
      const double side_x = -step[1] * width, side_y = step[0] * width;
      add_triangle({{{x + 4.0 * step[0], y + 4.0 * step[1], 30.0},
                     {x + side_x, y + side_y, 10.0},
                     {x - side_x, y - side_y, 10.0}}},
                   mesh);
      x += 1.0;
    }
    y -= 1.0;
  }
  EXPECT_GT(expect_exact_depths(mesh, Layer::nearest), 40U);
}

// A face whose plane passes close to the centre: 12 cells on, just behind the last entry, it is 10^4 times as
// far away, and the terms of its inverse depth in float are 600 times what they leave there.
TEST(FillGuards, PlanesAlmostThroughTheCentre) {
  for (const double beyond : {0.02, 0.002}) {
    TriangleMesh mesh;
    add_triangle({{{20.0, 28.5, 10.0}, {20.0, 35.5, 11.0}, {32.0 + beyond, 32.0, 1e5}}}, mesh);
    EXPECT_GT(expect_exact_depths(mesh, Layer::nearest), 20U);
  }
}

bool is_marked(const FloatCube& table, std::size_t column, std::size_t row) {
  const std::size_t cell = (4 * table.stride + row) * table.stride + column;  // of the face about +z
  return !table.none.empty() && (table.none[cell / 32] >> (cell % 32) & 1U) != 0U;
}

// A plate smaller than a cell, which no entry sees.
TEST(FillGuards, ARimThatNoEntrySees) {
  TriangleMesh mesh = sphere(20.0, 500);
  add_triangle({{{40.3, 40.3, 15.0}, {40.6, 40.3, 15.0}, {40.3, 40.6, 15.0}}}, mesh);
  EXPECT_TRUE(is_marked(guarded_table(mesh, guarded_fill(Layer::nearest)), 40, 40));
}

// A hidden rim is held against steep faces within the reach of its entries. The only one is in another tile.
TEST(FillGuards, ARimThatAFaceOfAnotherTileCallsSeen) {
  const auto with_spike = [](double far) {
    TriangleMesh mesh = sphere(20.0, 500);
    add_triangle({{{32.3, 40.3, 21.5}, {32.6, 40.3, 21.5}, {32.3, 40.6, 21.5}}}, mesh);  // the rim
    add_triangle({{{34.1, 40.3, 15.0}, {34.3, 40.3, far}, {34.1, 40.5, 15.0}}}, mesh);
    return mesh;
  };
  const TriangleMesh before = with_spike(18.0);
  const TriangleMesh after = with_spike(15.0);
  EXPECT_TRUE(is_marked(guarded_table(before, guarded_fill(Layer::nearest)), 32, 40));
  EXPECT_FALSE(is_marked(guarded_table(after, guarded_fill(Layer::nearest)), 32, 40));
}

}  // namespace
}  // namespace impinge
