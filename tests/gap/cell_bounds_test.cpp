// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: in a cell that is not open, |answer of the table - radius of the layer| <= bound, in every
// direction; sheets behind the layer that counts do not widen the bound
#include "gap/simd/cell_bounds.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "gap/simd/open_cells.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

// Of the cell that a direction is in, the entry that it begins at.
std::size_t first_entry(const CubeGnomonic& scheme, const Vec3& x) {
  const std::size_t n = scheme.divisions();
  const std::size_t cell = scheme.plane_stencil(x).cell;
  const std::size_t row = cell / n;
  return (row + row / n) * (n + 1) + cell % n;
}

struct Bounded {
  Bounded(const TriangleMesh& of, Layer which, std::size_t divisions)
      : mesh(of),
        layer(which),
        table(fill_exact(of, CubeGnomonic::with_precision(90.0 / static_cast<double>(divisions)), which)),
        bounds(cell_bounds(of, which, table)),
        open(open_cells(of, float_grid(divisions))) {}

  const TriangleMesh& mesh;
  Layer layer;
  InverseDepthTable<CubeGnomonic> table;
  std::vector<CellBound> bounds;
  std::vector<bool> open;
};

// The largest share of a bound that an error takes, and how many directions were in decided cells.
struct Tried {
  double largest_share = 0.0;
  std::size_t decided = 0;
};

Tried expect_bounds(const Bounded& made, const std::vector<Vec3>& directions) {
  const RayCaster caster(made.mesh);
  Tried tried;
  for (const Vec3& u : directions) {
    const std::size_t e = first_entry(made.table.scheme(), u);
    const double answer = made.table.radius_at(u);
    if (made.open[e] || std::isnan(answer) || std::isinf(made.bounds[e].mm)) continue;
    ++tried.decided;
    const double error = std::abs(answer - caster.cast(u, made.layer));
    EXPECT_LE(error, made.bounds[e].mm) << u.transpose();
    tried.largest_share = std::max(tried.largest_share, error / made.bounds[e].mm);
  }
  return tried;
}

std::vector<Vec3> all_directions(const TriangleMesh& mesh) {
  auto directions = test::random_directions(2000 + random_cases() / 5, 23);
  for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
  for (const Vec3& u : test::special_directions()) directions.push_back(u.normalized());
  return directions;
}

TEST(CellBoundsTest, HoldOnBallsAndSockets) {
  const BallSocketPair pair = make_ball_socket_pair(400, impinging_cam());
  for (const std::size_t divisions : std::vector<std::size_t>{5, 20, 61}) {
    for (const auto& [mesh, layer] :
         {std::pair{&pair.ball, Layer::farthest}, {&pair.socket, Layer::nearest}}) {
      const Tried tried = expect_bounds(Bounded(*mesh, layer, divisions), all_directions(*mesh));
      EXPECT_GT(tried.decided, 500U);
      EXPECT_GT(tried.largest_share, 0.2);  // it is no bound that nothing comes near to
    }
  }
}

// Two spheres that cross, so that the layer changes from one to the other within cells, off all edges.
TEST(CellBoundsTest, HoldWhereSheetsCross) {
  const TriangleMesh mesh =
      test::joined(test::askew(icosphere(20.0, 2)), test::moved(icosphere(20.5, 2), {3.0, 1.0, 0.5}));
  for (const Layer layer : {Layer::nearest, Layer::farthest}) {
    const Tried tried = expect_bounds(Bounded(mesh, layer, 25), all_directions(mesh));
    EXPECT_GT(tried.decided, 2000U);
    EXPECT_GT(tried.largest_share, 0.2);
  }
}

// Faces at random end everywhere: almost all cells are open, in the others the bound holds.
TEST(CellBoundsTest, HoldAmongFacesAtRandom) {
  std::size_t decided = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const TriangleMesh mesh = test::soup(6, seed);
    for (const Layer layer : {Layer::nearest, Layer::farthest})
      decided += expect_bounds(Bounded(mesh, layer, 30), all_directions(mesh)).decided;
  }
  EXPECT_GT(decided, 10000U);
}

TEST(CellBoundsTest, DoNotCountWhatIsHidden) {
  const TriangleMesh inner = test::askew(icosphere(20.0, 2));
  const TriangleMesh outer = icosphere(21.5, 2);
  const TriangleMesh shell = test::joined(inner, outer);
  const auto largest = [](const TriangleMesh& mesh, Layer layer) {
    double mm = 0.0;
    for (const CellBound& bound : Bounded(mesh, layer, 25).bounds) mm = std::max(mm, bound.mm);
    return mm;
  };
  EXPECT_EQ(largest(shell, Layer::nearest), largest(inner, Layer::nearest));
  EXPECT_EQ(largest(shell, Layer::farthest), largest(outer, Layer::farthest));
}

// On planes all is exact.
TEST(CellBoundsTest, IsRoundingOnFlatFaces) {
  const TriangleMesh box{
      {{-9, -9, -9}, {9, -9, -9}, {-9, 9, -9}, {9, 9, -9}, {-9, -9, 9}, {9, -9, 9}, {-9, 9, 9}, {9, 9, 9}},
      {{0, 2, 1},
       {1, 2, 3},
       {4, 5, 6},
       {5, 7, 6},
       {0, 1, 4},
       {1, 5, 4},
       {2, 6, 3},
       {3, 6, 7},
       {0, 4, 2},
       {2, 4, 6},
       {1, 3, 5},
       {3, 7, 5}}};
  const Bounded made(box, Layer::nearest, 8);
  const std::size_t middle = (4 * 9 + 3) * 9 + 2;  // away from the edges of the cube
  EXPECT_GT(made.bounds[middle].mm, 0.0);
  EXPECT_LT(made.bounds[middle].mm, 1e-6);
}

}  // namespace
}  // namespace impinge
