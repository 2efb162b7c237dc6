// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: along a straight line between two points in front of one face of the cube, the cells and places
// of for_each_cell_along() (table/rim.hpp), which searches for every change of cell:
//   the same cells in the same order, |x| of both ends of each stretch within 1e-9 of it
#include "table/fill/edge_cells.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/schemes/cube_gnomonic.hpp"
#include "table/rim.hpp"

namespace impinge {
namespace {

struct Line {
  Vec3 from;
  Vec3 to;
};

struct Place {
  std::size_t entry;
  double first;  // mm
  double last;   // mm
};

std::vector<Place> searched(const CubeGnomonic& scheme, const Line& line) {
  std::vector<Place> places;
  for_each_cell_along(scheme, RimLine{line.from, line.to},
                      [&](const Stencil& stencil, const Vec3& first, const Vec3& last) {
                        places.push_back({stencil.entry[0], first.norm(), last.norm()});
                      });
  return places;
}

std::vector<Place> stepped(const CubeGnomonic& scheme, const Line& line) {
  const std::size_t n = scheme.divisions();
  const SeenCorner from = seen_corner(line.from, n);
  const SeenCorner to = seen_corner(line.to, n);
  EXPECT_EQ(from.face, to.face);
  std::vector<Place> places;
  for_each_cell_of_line(from, to, n, [&](const EdgeCell& cell) {
    places.push_back(
        {(from.face * (n + 1) + cell.row) * (n + 1) + cell.column, cell.first.norm(), cell.last.norm()});
  });
  return places;
}

void expect_same_cells(std::size_t n, const Line& line) {
  const CubeGnomonic scheme = CubeGnomonic::with_precision(90.0 / static_cast<double>(n));
  const auto expected = searched(scheme, line);
  const auto places = stepped(scheme, line);
  ASSERT_EQ(places.size(), expected.size()) << n << " cells, from " << line.from.transpose();
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_EQ(places[k].entry, expected[k].entry) << "place " << k;
    EXPECT_NEAR(places[k].first / expected[k].first, 1.0, 1e-9) << "place " << k;
    EXPECT_NEAR(places[k].last / expected[k].last, 1.0, 1e-9) << "place " << k;
  }
}

// Of face `face`, at a distance from 1 to 100 mm.
Vec3 point_before(std::size_t face, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const double depth = std::pow(10.0, 1.0 + place(random));
  const auto axis = static_cast<Eigen::Index>(face / 2);
  Vec3 x;
  x[axis] = face % 2 == 0 ? depth : -depth;
  x[(axis + 1) % 3] = place(random) * depth;
  x[(axis + 2) % 3] = place(random) * depth;
  return x;
}

TEST(EdgeCells, LinesAcrossAFace) {
  std::mt19937 random(1);
  for (const std::size_t n : {1U, 2U, 5U, 32U, 101U}) {
    for (std::size_t k = 0; k < 60; ++k)
      expect_same_cells(n, {point_before(k % 6, random), point_before(k % 6, random)});
  }
}

TEST(EdgeCells, ShortLines) {
  std::mt19937 random(2);
  for (std::size_t k = 0; k < 600; ++k) {
    const Vec3 from = point_before(k % 6, random);
    const Vec3 to = 0.99 * from + 0.01 * point_before(k % 6, random);
    expect_same_cells(200, {from, to});
    expect_same_cells(200, {to, from});
  }
}

// Beside grid lines and diagonals, by as much as a rim is followed beside its edge.
TEST(EdgeCells, LinesBesideEntries) {
  const double aside = 3e-8;
  for (const double side : {-aside, aside}) {
    expect_same_cells(40, {{30, -20, 7.5 + side}, {30, 20, 7.5 + side}});
    expect_same_cells(40, {{7.5 + side, -30, 22}, {7.5 + side, -30, -21}});
    expect_same_cells(40, {{-15 + side, -15, -30}, {22.5 + side, 22.5, -30}});
    expect_same_cells(40, {{22.5, -30, -21 + side}, {-21, -30, 22.5 + side}});
  }
}

TEST(EdgeCells, APoint) {
  expect_same_cells(7, {{3, 2, 1}, {3, 2, 1}});
  expect_same_cells(7, {{3, 3, 3}, {3, 3, 3}});  // in the corner of the cube
}

}  // namespace
}  // namespace impinge
