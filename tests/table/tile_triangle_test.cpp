// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: side_of() is orientation() of the corners, or 0 where the grid does not tell; a face has the same
// window, plane and edges in a batch of any size as alone, and faces behind the batch are not seen
#include "table/fill/tile_triangle.hpp"

#include <array>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"

namespace impinge {
namespace {

constexpr std::size_t kCells = 50;

// Faces well inside each face of the cube, of any size and way round, some of them slivers.
TriangleMesh inside_faces() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-0.9, 0.9);
  TriangleMesh mesh;
  for (std::size_t f = 0; f < 1200; ++f) {
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    const double size = std::pow(0.1, static_cast<double>(f % 7));
    const std::array<double, 2> middle{place(random) * (1.0 - size), place(random) * (1.0 - size)};
    for (int k = 0; k < 3; ++k) {
      Vec3 v;
      const auto axis = static_cast<Eigen::Index>(f % 3);
      v[axis] = f % 2 == 0 ? 20.0 : -20.0;
      v[(axis + 1) % 3] = 20.0 * (middle[0] + size * place(random));
      v[(axis + 2) % 3] = 20.0 * (middle[1] + size * place(random));
      mesh.vertices.push_back(v * (1.5 + place(random)));
    }
    if (f % 11 == 0) mesh.vertices.back() = mesh.vertices[first] + mesh.vertices[first + 1];
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(TileTriangle, SidesAreThoseOfTheExactTest) {
  const TriangleMesh mesh = inside_faces();
  CubeView view(mesh, kCells);
  view.see(0, mesh.vertices.size());
  std::array<std::size_t, 3> known{};
  std::size_t unknown = 0;
  for (const Face& face : mesh.faces) {
    ASSERT_TRUE(view.inside_one(face));
    const int side = side_of({&view.corner(face[0]), &view.corner(face[1]), &view.corner(face[2])}, kCells);
    ++known[static_cast<std::size_t>(side + 1)];
    if (side != 0) {
      EXPECT_EQ(side, cone_of(mesh, face).side());
    } else {
      ++unknown;
    }
  }
  EXPECT_GT(known[0], 400U);
  EXPECT_GT(known[2], 400U);
  EXPECT_GT(unknown, 100U);  // the faces through the centre
}

CornerBatch batch_of(const CubeView& view, std::span<const std::uint32_t> faces) {
  CornerBatch batch;
  for (const std::uint32_t f : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const SeenCorner& corner = view.corner(view.mesh().faces[f][k]);
      batch.x[k][batch.count] = corner.x;
      batch.y[k][batch.count] = corner.y;
      batch.q[k][batch.count] = corner.q;
    }
    batch.faces[batch.count++] = f;
  }
  return batch;
}

// Face k of the batch is that of the mesh.
void expect_drawn(const TileTriangles& drawn, std::size_t k, const CubeTile& tile, const SeenFace& seen) {
  const GridWindow window = window_in(tile, seen.window);
  ASSERT_EQ((drawn.seen >> k & 1U) != 0U, !window.empty());
  if (window.empty()) return;
  const SeenPlane plane = plane_of(seen, kCells);
  EXPECT_EQ(drawn.first_column[k], window.first_column - static_cast<long>(tile.first_column));
  EXPECT_EQ(drawn.first_row[k], window.first_row - static_cast<long>(tile.first_row));
  EXPECT_EQ(drawn.columns[k], window.last_column - window.first_column + 1);
  EXPECT_EQ(drawn.rows[k], window.last_row - window.first_row + 1);
  EXPECT_EQ(drawn.q_x[k], static_cast<float>(plane.q_x));
  EXPECT_EQ(drawn.q_y[k], static_cast<float>(plane.q_y));
  EXPECT_EQ(drawn.edge_x[1][k], static_cast<float>(plane.side * (seen.corners[1].y - seen.corners[2].y)));
  EXPECT_EQ(drawn.edge_y[2][k], static_cast<float>(plane.side * (seen.corners[0].x - seen.corners[2].x)));
  EXPECT_GT(drawn.doubt[k], 0.0F);
}

TEST(TileTriangle, BatchesOfAnySize) {
  TriangleMesh mesh = sphere(22.0, 4000);
  for (std::size_t f = 0; f < mesh.faces.size(); f += 2) std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  CubeView view(mesh, kCells);
  view.see(0, mesh.vertices.size());
  const CubeTile tile = CubeTiling(kCells)[0];
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (view.in_front(mesh.faces[f], tile.face)) faces.push_back(f);
  ASSERT_GT(faces.size(), CornerBatch::kMost);
  for (const std::size_t size : {0U, 1U, 7U, 63U, 64U}) {
    TileTriangles drawn;
    const CornerBatch batch = batch_of(view, std::span(faces).first(size));
    set_up(batch, tile, kCells, drawn);
    EXPECT_EQ(drawn.clear, drawn.seen);
    EXPECT_EQ(size == 64U ? 0U : drawn.seen >> size, 0U);
    for (std::size_t k = 0; k < size; ++k)
      expect_drawn(drawn, k, tile, view.seen(mesh.faces[faces[k]], tile.face));
  }
}

// Lines are kept by the tile that a division finds, up to the largest table that a kernel reads.
TEST(TileTriangle, TilesOfLines) {
  for (const std::size_t cells : {1U, 62U, 63U, 64U, 256U, 1000U, 18917U}) {
    const CubeTiling tiling(cells);
    const CubeTile first = tiling[0];
    for (long line = 0; line <= static_cast<long>(cells); ++line) {
      std::size_t last = 0;
      tiling.for_each_seeing(0, {line, line, 0, 0}, [&](std::size_t tile) { last = tile; });
      ASSERT_EQ(last, static_cast<std::size_t>(line) / first.columns) << cells << ' ' << line;
    }
  }
}

}  // namespace
}  // namespace impinge
