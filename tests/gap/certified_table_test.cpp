// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for every vertex the sign of gap - threshold, or that there is no gap, is that of the exact
// cells; what they were not asked about is within the bound of what they say
#include "gap/simd/certified_table.hpp"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "sphere/uniform_directions.hpp"
#include "support/directions.hpp"
#include "support/random_cases.hpp"
#include "support/soup.hpp"

namespace impinge {
namespace {

int side(float gap, float threshold) {
  return std::isnan(gap) ? 2 : gap > threshold ? 1 : gap < threshold ? -1 : 0;
}

struct Asked {
  const CertifiedTable& table;
  const PackedVertices<float>& vertices;
  Pose pose;
  Surface scanned;
};

// Returns how many vertices went to the exact cells.
std::size_t expect_sides(const Asked& asked, float threshold) {
  std::vector<float> exact(asked.vertices.size());
  scan_gaps(asked.table.exact, asked.vertices, asked.pose, asked.scanned, exact);
  CertifiedGaps found;
  found.threshold = threshold;
  scan_gaps(asked.table, asked.vertices, asked.pose, asked.scanned, found);
  EXPECT_EQ(found.gap.size(), exact.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const bool asked_for = next < found.undecided.size() && found.undecided[next] == i;
    next += asked_for ? 1U : 0U;
    EXPECT_EQ(side(found.gap[i], threshold), side(exact[i], threshold)) << found.gap[i] << " " << exact[i];
    if (asked_for) {
      EXPECT_TRUE(found.gap[i] == exact[i] || std::isnan(exact[i]));
    }
    if (!asked_for && !std::isnan(exact[i])) {
      EXPECT_NEAR(found.gap[i], exact[i], 1.01 * asked.table.bound_mm);
    }
  }
  EXPECT_EQ(next, found.undecided.size());
  return found.undecided.size();
}

// Thresholds at the gaps of the vertices themselves and a little beside them: the worst that can be asked.
TEST(CertifiedTableTest, IsOnTheSideOfTheExactCells) {
  const BallSocketPair pair = make_ball_socket_pair(1000, impinging_cam());
  std::mt19937_64 random(8);
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    const bool first = scanned == Surface::ball;
    const CertifiedTable table =
        certified_table(first ? pair.socket : pair.ball, first ? Layer::nearest : Layer::farthest, 40);
    const auto vertices = packed_vertices<float>(first ? pair.ball.vertices : pair.socket.vertices);
    std::size_t undecided = 0;
    for (int k = 0; k < 40; ++k) {
      Pose pose;
      pose.rotation = Eigen::AngleAxisd(-2.0 * k * kDegree, Vec3::UnitY()).toRotationMatrix();
      pose.translation = 0.5 * uniform_direction(random);
      const auto threshold = static_cast<float>(k % 2 == 0 ? 0.0 : 4.0 * uniform(random));
      undecided += expect_sides({table, vertices, pose, scanned}, threshold);
    }
    EXPECT_GT(undecided, 0U);
    EXPECT_LT(undecided, 40 * vertices.size() / 4);
  }
}

// Where the table is worst a threshold next to the exact gap is on the wrong side of that of the table, by
// more than a quarter of the bound, which comes from the corners of cells alone.
TEST(CertifiedTableTest, HoldsWhereTheTableIsWorst) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  for (const TriangleMesh& mesh : {pair.ball, pair.socket}) {
    const CertifiedTable table = certified_table(mesh, Layer::nearest, 21);
    auto directions = test::random_directions(20000, 17);
    for (const Vec3& u : test::feature_directions(mesh)) directions.push_back(u);
    const auto points = packed_vertices<float>(directions);
    CertifiedGaps far;
    far.threshold = -1e6F;
    scan_gaps(table, points, {}, Surface::ball, far);
    std::vector<float> exact(points.size());
    scan_gaps(table.exact, points, {}, Surface::ball, exact);
    std::size_t worst = 0;
    const auto error = [&](std::size_t i) { return std::abs(far.gap[i] - exact[i]); };
    for (std::size_t i = 0; i < exact.size(); ++i)
      if (error(i) > error(worst) || std::isnan(error(worst))) worst = i;
    EXPECT_LE(error(worst), table.bound_mm);
    EXPECT_GT(error(worst), 0.25 * table.bound_mm);
    expect_sides({table, points, {}, Surface::ball}, std::nextafter(exact[worst], far.gap[worst]));
    expect_sides({table, points, {}, Surface::ball}, exact[worst]);
  }
}

// A plane whose inverse depth, linear and exact in the table, rises from cell to cell by up to 95 times its
// least: roundings of the place are all there is.
TEST(CertifiedTableTest, HoldsOnSteepFaces) {
  constexpr std::size_t kCells = 291;
  constexpr double kStep = 2.0 / kCells;
  std::mt19937_64 random(11);
  for (std::size_t k = 0; k < random_cases(); k += 1000) {
    const double line = -1.0 + kStep * std::floor((0.9 + 0.09 * uniform(random)) * kCells);
    const double rise = 95.0 * uniform(random);            // of the inverse depth, a cell
    const auto at = [&](double cells, double b) -> Vec3 {  // beyond the line
      return 20.0 / (1.0 + rise * cells) * Vec3(line + kStep * cells, b, 1.0);
    };
    const TriangleMesh mesh{{at(-0.01, 0.0), at(4.0, 0.0), at(4.0, 5.0 * kStep), at(-0.01, 5.0 * kStep)},
                            {{0, 1, 2}, {0, 2, 3}}};
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 2000; ++i)
      points.push_back(at(std::pow(uniform(random), 6.0), 5.0 * kStep * uniform(random)));
    const CertifiedTable table = certified_table(mesh, Layer::nearest, kCells);
    expect_sides({table, packed_vertices<float>(points), {}, Surface::ball}, -1e6F);
  }
}

// The bound says nothing of a face that doubles hardly tell from one seen edge-on: a wall between two planes
// that the surface does not leave.
TEST(CertifiedTableTest, CellsOfWallsThatAreAllButEdgeOnAreOpen) {
  for (const double width : {1e-3, 5e-8}) {
    const double foot = 2.5 + width;
    const TriangleMesh mesh{{{-18, -18, 20},
                             {5, -18, 20},
                             {5, 18, 20},
                             {-18, 18, 20},
                             {foot, -9, 10},
                             {foot, 9, 10},
                             {9, -9, 10},
                             {9, 9, 10}},
                            {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {4, 6, 7}, {4, 7, 5}}};
    CertifiedGaps found;
    found.threshold = -1e6F;
    const auto points = packed_vertices<float>(std::vector<Vec3>{{-0.25, 0.05, 1.0}, {0.25, 0.05, 1.0}});
    scan_gaps(certified_table(mesh, Layer::nearest, 10), points, {}, Surface::ball, found);
    EXPECT_EQ(found.undecided, std::vector<std::uint32_t>{1});
  }
}

// A place that float takes for one in a cell that answers may be in the cell beside, which does not.
TEST(CertifiedTableTest, CellsBesideOnesWithoutAnAnswerAreOpen) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const CertifiedTable made = certified_table(pair.socket, Layer::nearest, 31);
  const auto& table = made.table;
  const auto bit = [](const std::vector<std::uint32_t>& bits, std::size_t e) {
    return (bits[e / 32] >> (e % 32) & 1U) != 0U;
  };
  std::size_t beside = 0;
  for (std::size_t e = table.stride + 1; e + table.stride + 1 < table.values.size(); ++e) {
    if (!bit(table.none, e)) continue;
    for (const std::size_t next : {e - table.stride, e - 1, e + 1, e + table.stride}) {
      if (next % table.stride == 31 || next / table.stride % table.stride == 31 || bit(table.none, next))
        continue;
      ++beside;
      EXPECT_TRUE(bit(made.open, next)) << e << " " << next;
    }
  }
  EXPECT_GT(beside, 50U);
}

TEST(CertifiedTableTest, LayersAndNumbersOfVertices) {
  const TriangleMesh mesh = test::soup(60, 4);
  const CertifiedTable table = certified_table(mesh, Layer::nearest, 10);
  auto points = test::random_directions(70, 2);
  for (Vec3& x : points) x *= 20.0;
  for (std::size_t count = 0; count <= points.size(); ++count) {
    const auto some = packed_vertices<float>(std::span(points).first(count));
    expect_sides({table, some, {}, Surface::ball}, 1.0F);
  }
}

}  // namespace
}  // namespace impinge
