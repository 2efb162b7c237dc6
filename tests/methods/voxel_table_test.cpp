// SPDX-License-Identifier: GPL-3.0-or-later
// Contract:
//   Eq. 1   id = x - Min X + (y - Min Y) (Dim X + 1) + (z - Min Z) (Dim X + 1) (Dim Y + 1), Eq. 2-4 its
//   inverse a voxel is kept if and only if a face has a point in it (oracle: distance of the face from the
//   closed cube) hu_voxels hits only where the surfaces are at most 3/2 sqrt(3) h apart
#include "methods/voxel_table.hpp"

#include <algorithm>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/triangle_distance.hpp"
#include "methods/hu_voxels.hpp"
#include "methods/surface_distance.hpp"
#include "support/directions.hpp"

namespace impinge::lab {
namespace {

TEST(VoxelBox, NumbersVoxelsOnceAsEquation1To4) {
  const VoxelBox box{0.5, {-3, 2, -7}, {4, 2, 5}};
  ASSERT_EQ(box.count(), 5U * 3U * 6U);
  std::set<std::size_t> ids;
  for (long z = -7; z <= -2; ++z) {
    for (long y = 2; y <= 4; ++y) {
      for (long x = -3; x <= 1; ++x) {
        const std::size_t id = box.id({x, y, z});
        EXPECT_EQ(static_cast<long>(id), (x + 3) + (y - 2) * 5 + (z + 7) * 5 * 3);
        EXPECT_EQ(box.voxel(id), (Voxel{x, y, z}));
        ids.insert(id);
      }
    }
  }
  EXPECT_EQ(ids.size(), box.count());
  EXPECT_EQ(*ids.rbegin(), box.count() - 1);
  for (const Voxel& out : {Voxel{-4, 2, -7}, {2, 2, -7}, {-3, 1, -7}, {-3, 5, -7}, {-3, 2, -8}, {-3, 2, -1}})
    EXPECT_FALSE(box.contains(out));
}

TEST(VoxelTable, FloorsNegativeCoordinates) {
  EXPECT_EQ(voxel_at(Vec3(-0.1, 0.1, -2.0), 0.5), (Voxel{-1, 0, -4}));
  EXPECT_EQ(centre_of({-1, 0, -4}, 0.5), Vec3(-0.25, 0.25, -1.75));
}

// Least distance between the triangle and the cube, whose surface is twelve triangles; 0 where one holds the
// other.
double distance_from_cube(const Triangle& t, const Vec3& middle, double half) {
  double least = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-half, half}) {
      const Vec3 a = half * Vec3::Unit((axis + 1) % 3);
      const Vec3 b = half * Vec3::Unit((axis + 2) % 3);
      const Vec3 face = middle + side * Vec3::Unit(axis);
      for (const Triangle& s : {Triangle{face - a - b, face + a - b, face + a + b},
                                Triangle{face - a - b, face + a + b, face - a + b}}) {
        // Crossing triangles: an edge of one goes through the other, at distance 0 of a dense row of points.
        for (std::size_t k = 0; k < 3; ++k) {
          for (int i = 0; i <= 24; ++i) {
            const Vec3 p = t[k] + i / 24.0 * (t[(k + 1) % 3] - t[k]);
            const Vec3 q = s[k] + i / 24.0 * (s[(k + 1) % 3] - s[k]);
            if ((p - middle).lpNorm<Eigen::Infinity>() <= half) return 0.0;
            least = std::min({least, squared_distance_to_triangle(p, s[0], s[1], s[2]),
                              squared_distance_to_triangle(q, t[0], t[1], t[2])});
          }
        }
      }
    }
  }
  return std::sqrt(least);
}

TEST(SurfaceVoxels, AreThoseThatAFaceMeets) {
  const std::vector<Vec3> u = test::random_directions(3 * 4, 3);
  constexpr double kSize = 0.7;
  constexpr double kSpacing = 0.1;  // of the oracle's rows of points: nearer than that may be a crossing
  std::size_t inside = 0;
  for (std::size_t k = 0; k < u.size(); k += 3) {
    const TriangleMesh mesh{{1.5 * u[k], 1.1 * u[k + 1], u[k + 2]}, {{0, 1, 2}}};
    const std::vector<Voxel> voxels = surface_voxels(mesh, kSize);
    for (long z = -3; z < 3; ++z) {
      for (long y = -3; y < 3; ++y) {
        for (long x = -3; x < 3; ++x) {
          const double apart = distance_from_cube({mesh.vertices[0], mesh.vertices[1], mesh.vertices[2]},
                                                  centre_of({x, y, z}, kSize), 0.5 * kSize);
          const bool kept = std::ranges::binary_search(voxels, Voxel{x, y, z});
          inside += kept ? 1U : 0U;
          const bool in_doubt = apart > 0.0 && apart <= kSpacing;
          EXPECT_TRUE(in_doubt || kept == (apart == 0.0)) << apart;
        }
      }
    }
  }
  EXPECT_GT(inside, 30U);
}

TEST(SurfaceVoxels, RefuseWhatIsNoVoxel) {
  const TriangleMesh mesh = octahedron(10.0);
  EXPECT_THROW(surface_voxels(mesh, 0.0), std::invalid_argument);
  EXPECT_THROW(surface_voxels(mesh, -1.0), std::invalid_argument);
  EXPECT_THROW(surface_voxels(mesh, 1e-6), std::invalid_argument);
  EXPECT_THROW(make_voxel_table({}, 1.0), std::invalid_argument);
  EXPECT_THROW(make_voxel_table({{0, 0, 0}, {2000, 2000, 2000}}, 1.0), std::invalid_argument);
}

TEST(HuVoxels, HitsOnlyWhereTheSurfacesAreNear) {
  constexpr double kSize = 0.8;
  const BallSocketPair pair = make_ball_socket_pair(300);
  HuVoxels voxels(pair.ball, pair.socket, kSize);
  int hits = 0;
  int near = 0;
  for (const double moved : {0.0, 1.5, 2.5, 3.0, 3.5, 4.5, 6.0}) {
    BenchmarkScene scene{"", pair, {}};
    scene.pose.rotation = Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
    scene.pose.translation = Vec3(0.3, 0.2, 1.0).normalized() * moved;
    const double apart = surface_distance(scene);
    if (voxels.touches(scene.pose)) {
      ++hits;
      EXPECT_LE(apart, kVoxelReach * kSize) << moved;
    } else {
      EXPECT_GT(apart, 0.0) << "a deep contact is not missed";
    }
    near += apart > 0.0 && apart < kSize ? 1 : 0;
  }
  EXPECT_GE(hits, 3);
  EXPECT_LE(hits, 6);
  EXPECT_GE(near, 1);
}

TEST(HuVoxels, ReportsCollidedPointsInMarkedVoxels) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  HuVoxels voxels(pair.ball, pair.socket, 1.0);
  Pose pose;
  pose.translation = Vec3(0.0, 0.0, 5.0);
  const std::vector<Vec3> points = voxels.collided(pose);
  ASSERT_FALSE(points.empty());
  EXPECT_LT(points.size(), voxels.ball_voxels());
  for (const Vec3& x : points) {
    double least = 1e9;
    for (const Face& f : pair.socket.faces)
      least =
          std::min(least, squared_distance_to_triangle(x, corner(pair.socket, f, 0),
                                                       corner(pair.socket, f, 1), corner(pair.socket, f, 2)));
    EXPECT_LE(std::sqrt(least), std::sqrt(3.0));
  }
  EXPECT_EQ(voxels.bytes(), voxels.table().box.count() + voxels.ball_voxels() * 24);
}

}  // namespace
}  // namespace impinge::lab
