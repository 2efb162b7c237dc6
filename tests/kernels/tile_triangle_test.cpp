// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: side_of() is orientation() of the corners, or 0 where the grid does not tell; planes that are
// clear pass through the corners; what is ready to be drawn agrees with both, face by face
#include "kernels/tile_triangle.hpp"

#include <array>
#include <cmath>
#include <random>
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

// 100 faces in batches of 1, 7, 63 and 64: each has the numbers of its own plane and edges.
TEST(TileTriangle, BatchesOfAnySize) {
  const TriangleMesh mesh = sphere(22.0, 4000);
  CubeView view(mesh, kCells);
  view.see(0, mesh.vertices.size());
  const CubeTile tile = CubeTiling(kCells)[0];
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (view.in_front(mesh.faces[f], tile.face)) faces.push_back(f);
  ASSERT_GT(faces.size(), 100U);
  for (const std::size_t size : {1U, 7U, 63U, 64U}) {
    CornerBatch batch;
    for (; batch.count < size; ++batch.count) {
      const SeenFace seen = view.seen(mesh.faces[faces[batch.count]], tile.face);
      batch.faces[batch.count] = faces[batch.count];
      for (std::size_t k = 0; k < 3; ++k) {
        batch.x[k][batch.count] = seen.corners[k].x;
        batch.y[k][batch.count] = seen.corners[k].y;
        batch.q[k][batch.count] = seen.corners[k].q;
      }
    }
    TileTriangles drawn;
    set_up(batch, tile, kCells, drawn);
    EXPECT_EQ(drawn.seen & ~drawn.clear, 0U);
    for (std::size_t f = 0; f < CornerBatch::kMost; ++f) {
      const bool is_seen = (drawn.seen >> f & 1U) != 0U;
      if (f >= size) {
        EXPECT_FALSE(is_seen);
        continue;
      }
      const SeenFace seen = view.seen(mesh.faces[faces[f]], tile.face);
      const GridWindow window = window_in(tile, seen.window);
      ASSERT_EQ(is_seen, !window.empty());
      if (!is_seen) continue;
      const SeenPlane plane = plane_of(seen, kCells);
      EXPECT_EQ(drawn.first_column[f], window.first_column - static_cast<long>(tile.first_column));
      EXPECT_EQ(drawn.first_row[f], window.first_row - static_cast<long>(tile.first_row));
      EXPECT_EQ(drawn.columns[f], window.last_column - window.first_column + 1);
      EXPECT_EQ(drawn.rows[f], window.last_row - window.first_row + 1);
      EXPECT_EQ(drawn.q_x[f], static_cast<float>(plane.q_x));
      EXPECT_EQ(drawn.q_y[f], static_cast<float>(plane.q_y));
      EXPECT_EQ(drawn.edge_x[1][f], static_cast<float>(plane.side * (seen.corners[1].y - seen.corners[2].y)));
      EXPECT_GT(drawn.doubt[f], 0.0F);
    }
  }
}

}  // namespace
}  // namespace impinge
