// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, at points that are floats:
//   |gap of the cells - gap of the mesh| <= u (18 r + 8 |gap|), and an answer exactly where the mesh has one
// with a pose, besides, what a displacement of 10.4 u (|v| + |t|) does
#include "gap/simd/exact_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "gap/simd/hit_cells.hpp"
#include "gap/simd/seen_planes.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/jump_edges.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/uniform_directions.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "support/soup.hpp"
#include "support/turned.hpp"
#include "table/packed_fixture.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

constexpr double kUnit = 0x1p-24;

// Points that are floats along random directions, through the features of the mesh and along axes and edges
// of the cube.
std::vector<Vec3> probes(const TriangleMesh& mesh, std::size_t features) {
  std::vector<Vec3> points = test::random_directions(features, 11);
  const auto through = test::feature_directions(mesh);
  const std::size_t step = through.size() / features + 1;
  for (std::size_t k = 0; k < through.size(); k += step) points.push_back(through[k]);
  for (const Vec3& x : test::special_directions()) points.push_back(x);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0})
        if (x != 0.0 || y != 0.0 || z != 0.0) points.emplace_back(x, y, z);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = as_floats((10.0 + 0.25 * static_cast<double>(k % 101)) * points[k]);
  return points;
}

std::vector<float> gaps(const ExactCells& cells, const std::vector<Vec3>& points, const Pose& pose,
                        Surface scanned) {
  std::vector<float> gap(points.size());
  scan_gaps(cells, packed_vertices<float>(points), pose, scanned, gap);
  return gap;
}

void expect_exact(const TriangleMesh& mesh, Layer layer, const std::vector<Vec3>& points) {
  const ExactCells cells = exact_cells(mesh, layer);
  const RayCaster caster(mesh);
  const auto gap = gaps(cells, points, {}, Surface::ball);
  const auto other = gaps(cells, points, {}, Surface::socket);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = caster.cast(points[i].normalized(), layer);
    const double exact = radius - points[i].norm();
    ASSERT_EQ(std::isnan(gap[i]), std::isnan(exact)) << points[i].transpose();
    ASSERT_EQ(std::isnan(other[i]), std::isnan(exact)) << points[i].transpose();
    if (std::isnan(exact)) continue;
    const double bound = kUnit * (18.0 * radius + 8.0 * std::abs(exact));
    ASSERT_NEAR(gap[i], exact, bound) << points[i].transpose();
    ASSERT_NEAR(other[i], -exact, bound) << points[i].transpose();
  }
}

TEST(ExactCellsTest, AnswerAsAllTrianglesDo) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  for (const TriangleMesh& mesh : {pair.ball, pair.socket, octahedron(20.0), cone(),
                                   sphere(22.0, 600, {15.0, -4.0, 9.0}), test::soup(60, 3)}) {
    expect_exact(mesh, Layer::nearest, probes(mesh, 2000));
    expect_exact(mesh, Layer::farthest, probes(mesh, 2000));
  }
}

// Two layers with a wall between their rims, as of a bone: turned against each other, so that the wall is
// steep and not edge-on. `thickness` mm, less than 0 for a second layer within the first.
TriangleMesh shell(std::size_t faces, double thickness) {
  const TriangleMesh layer = cup(20.0, 80.0, faces);
  TriangleMesh both = test::joined(
      layer, test::turned(test::inside_out(cup(20.0 + thickness, 80.0, faces)), 0.05, Vec3::UnitZ()));
  const auto other = static_cast<VertexIndex>(layer.vertices.size());
  for (const JumpEdge& rim : jump_edges(layer)) {
    both.faces.push_back({rim.from, rim.to, rim.to + other});
    both.faces.push_back({rim.from, rim.to + other, rim.from + other});
  }
  return both;
}

TEST(ExactCellsTest, LayersBehindAnother) {
  const TriangleMesh bumpy =
      radial_body(800, [](const Vec3& u) { return 20.0 + 3.0 * std::sin(8.0 * u.x()); });
  for (const TriangleMesh& mesh :
       {shell(800, 2.0), shell(800, 0.1), shell(800, -3.0), test::joined(bumpy, sphere(20.0, 700)),
        test::joined(shell(300, 2.0), sphere(20.5, 500)),
        test::joined(cup(20.0, 80.0, 800), sphere(24.0, 500)),
        test::joined(cup(24.0, 80.0, 800), sphere(20.0, 500)),
        test::joined(test::joined(sphere(20.0, 300), sphere(20.4, 500)), sphere(24.0, 900))}) {
    expect_exact(mesh, Layer::nearest, probes(mesh, 2000));
    expect_exact(mesh, Layer::farthest, probes(mesh, 2000));
  }
}

// Cells that a face may be met in, and those of them that are not smooth.
struct CellCount {
  std::size_t met = 0;
  std::size_t rough = 0;
};
CellCount count_cells(const TriangleMesh& mesh, Layer layer) {
  CellCount count;
  const ExactCells made = exact_cells(mesh, layer);
  for (const ExactCell& cell : made.cells) count.rough += cell.count > 0 ? 1U : 0U;
  count.met = made.cells.size();
  for (const std::uint32_t bits : made.none) count.met -= static_cast<std::size_t>(std::popcount(bits));
  return count;
}

TEST(ExactCellsTest, ALayerBehindAnotherMakesNoCellRough) {
  const TriangleMesh layer = sphere(20.0, 3000);
  const TriangleMesh beyond = test::joined(layer, sphere(22.0, 300));
  const TriangleMesh within = test::joined(layer, sphere(18.0, 300));
  const CellCount one = count_cells(layer, Layer::nearest);
  EXPECT_LE(count_cells(beyond, Layer::nearest).rough, one.rough + one.rough / 10);
  EXPECT_LE(count_cells(within, Layer::farthest).rough, one.rough + one.rough / 10);
  EXPECT_GT(count_cells(test::joined(layer, sphere(20.0, 300, {1, 2, 2})), Layer::nearest).rough,
            2 * one.rough);
}

TEST(ExactCellsTest, MeshesOfNoFaceOrOne) {
  expect_exact({{}, {}}, Layer::nearest, test::random_directions(50, 1));
  const TriangleMesh one{{Vec3(20, 0, 0), Vec3(0, 20, 0), Vec3(0, 0, 20)}, {{0, 1, 2}}};
  expect_exact(one, Layer::nearest, probes(one, 100));
  const TriangleMesh edge_on{{Vec3(20, 0, 0), Vec3(0, 20, 0), Vec3(10, 5, 0)}, {{0, 1, 2}}};
  expect_exact(edge_on, Layer::farthest, probes(edge_on, 100));
}

TEST(ExactCellsTest, MostCellsOfASmoothSurfaceNeedNoEdges) {
  const BallSocketPair pair = make_ball_socket_pair(3000);
  for (const TriangleMesh& mesh : {pair.ball, pair.socket}) {
    const auto [met, rough] = count_cells(mesh, Layer::nearest);
    EXPECT_LT(20 * rough, met);
  }
}

TEST(ExactCellsTest, BothScansOfARealPairInAnyPose) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  std::mt19937_64 random(5);
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    const bool first = scanned == Surface::ball;
    const TriangleMesh& mesh = first ? pair.socket : pair.ball;
    const Layer layer = first ? Layer::nearest : Layer::farthest;
    const auto& vertices = first ? pair.ball.vertices : pair.socket.vertices;
    const ExactCells cells = exact_cells(mesh, layer);
    const RayCaster caster(mesh);
    for (int k = 0; k < 10; ++k) {
      Pose pose;
      pose.rotation = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
      pose.translation = 2.0 * (uniform(random) - 0.5) * uniform_direction(random);
      const auto gap = gaps(cells, vertices, pose, scanned);
      for (std::size_t i = 0; i < gap.size(); ++i) {
        const Vec3 x = first ? to_socket(pose, vertices[i]) : to_ball(pose, vertices[i]);
        const double radius = caster.cast(x.normalized(), layer);
        const double exact = first ? radius - x.norm() : x.norm() - radius;
        if (std::isnan(exact) || std::isnan(gap[i])) continue;
        const double moved = 10.4 * kUnit * (vertices[i].norm() + pose.translation.norm());
        ASSERT_NEAR(gap[i], exact, kUnit * (18.0 * radius + 8.0 * std::abs(exact)) + 2.0 * moved);
      }
    }
  }
}

// |m| |x| of a plane is what its s is off by: at the far face below that of the near one is seen at 1 / 6.
TEST(ExactCellsTest, NoPlaneOfASmoothCellIsSteepWhereAnotherFaceIs) {
  const auto bend = [](double far) {
    const TriangleMesh mesh{{{0, 0, 10}, {28, 0, 10}, {28, 5, 10}, {far, -5, 0}, {far, 5, 0}, {far, 0, 10}},
                            {{0, 1, 2}, {3, 4, 5}}};
    const std::vector<Vec3> planes = seen_planes(mesh);
    return bend_of({mesh, planes}, std::vector<std::uint32_t>{0, 1});
  };
  EXPECT_EQ(bend(35.0), 1);
  EXPECT_EQ(bend(60.0), std::nullopt);
}

TEST(ExactCellsTest, GrowWithTheFaces) {
  const auto bytes = [](std::size_t faces) {
    const TriangleMesh mesh = sphere(20.0, faces);
    return exact_cells(mesh, Layer::nearest).bytes();
  };
  EXPECT_LT(bytes(8000), 10 * bytes(1000));
  EXPECT_GT(bytes(8000), 6 * bytes(1000));
}

// Contract: every cell that a direction of the cone is in is found, each once, and few others

// The entry that the cell of x begins at.
std::uint32_t cell_of(const CubeGnomonic& scheme, const Vec3& x) {
  return static_cast<std::uint32_t>(scheme.stencil(x).entry[0]);
}

Vec3 some_direction(const std::array<Vec3, 3>& corners, std::mt19937_64& random) {
  const double a = uniform(random);
  const double b = uniform(random) * (1.0 - a);
  return a * corners[0] + b * corners[1] + (1.0 - a - b) * corners[2];
}

TEST(CellsMet, HoldEveryDirectionOfTheConeAndFewMore) {
  std::mt19937_64 random(9);
  std::size_t found = 0;
  std::size_t needed = 0;
  for (int round = 0; round < 200; ++round) {
    const double size = round % 4 == 0 ? 1.5 : round % 4 == 1 ? 0.3 : 0.03;
    const Vec3 u = uniform_direction(random);
    std::array<Vec3, 3> corners;
    for (Vec3& v : corners)
      v = (5.0 + 20.0 * uniform(random)) * (u + size * uniform_direction(random)).normalized();
    const auto scheme = CubeGnomonic::with_precision(90.0 / 20.0);
    std::vector<std::uint32_t> cells;
    add_hit_cells({20, 1e-6}, TriangleCone(corners[0], corners[1], corners[2]), cells);
    const std::set<std::uint32_t> once(cells.begin(), cells.end());
    EXPECT_EQ(once.size(), cells.size());
    std::set<std::uint32_t> seen;
    for (int k = 0; k < 2000; ++k) seen.insert(cell_of(scheme, some_direction(corners, random)));
    for (std::size_t k = 0; k < 3 * 500; ++k) {
      const double share = static_cast<double>(k / 3) / 500.0;
      seen.insert(cell_of(scheme, corners[k % 3] + share * (corners[(k + 1) % 3] - corners[k % 3])));
    }
    EXPECT_TRUE(std::ranges::includes(once, seen));
    if (size > 1.0) continue;  // too large for so few directions to be in every cell
    found += once.size();
    needed += seen.size();
  }
  EXPECT_LT(static_cast<double>(found), 1.1 * static_cast<double>(needed));
}

TEST(CellsMet, WiderByTheMargin) {
  std::vector<std::uint32_t> cells;
  const Vec3 x(1.0, 0.05, 0.05);  // in the cell behind the middle of a face, a quarter from its sides
  add_hit_cells({20, 0.4}, TriangleCone(x, x, x), cells);
  EXPECT_EQ(cells.size(), 1U);
  cells.clear();
  add_hit_cells({20, 0.6}, TriangleCone(x, x, x), cells);
  EXPECT_EQ(cells.size(), 9U);
}

// Two faces over one edge, the far corner of the second above or below the plane of the first.
TEST(SeenPlanes, BendOneWayOrTheOther) {
  const auto bend = [](double height) {
    const TriangleMesh mesh{{{0, 0, 20}, {1, 0, 20}, {0, 1, 20}, {1, 1, height}}, {{0, 1, 2}, {1, 3, 2}}};
    const std::vector<std::uint32_t> both{0, 1};
    return bend_of({mesh, seen_planes(mesh)}, both);
  };
  EXPECT_EQ(bend(19.0), 1);
  EXPECT_EQ(bend(21.0), -1);
  EXPECT_EQ(bend(20.0), 1);
  const TriangleMesh layers{{{0, 0, 20}, {1, 0, 20}, {0, 1, 20}, {0, 0, 21}, {1, 0, 19}, {0, 1, 21}},
                            {{0, 1, 2}, {3, 4, 5}}};
  const std::vector<std::uint32_t> both{0, 1};
  EXPECT_FALSE(bend_of({layers, seen_planes(layers)}, both));
  const TriangleMesh steep{{{20, 0, 0.1}, {0, 20, 0.1}, {-20, -20, 0.1}}, {{0, 1, 2}}};
  const std::vector<std::uint32_t> alone{0};
  EXPECT_FALSE(bend_of({steep, seen_planes(steep)}, alone));
}

}  // namespace
}  // namespace impinge
