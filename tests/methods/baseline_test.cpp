// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/triangle_distance.hpp"
#include "methods/cartesian_field.hpp"
#include "methods/hu_voxels.hpp"
#include "methods/maciel_triangles.hpp"
#include "methods/pose_set.hpp"
#include "support/directions.hpp"
#include "support/joined.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

// Contract:
//   Eq. 1   id = x - Min X + (y - Min Y) (Dim X + 1) + (z - Min Z) (Dim X + 1) (Dim Y + 1), Eq. 2-4 its
//   inverse a voxel is kept if and only if a face has a point in it (oracle: distance of the face from the
//   closed cube) hu_voxels hits only where the surfaces are at most 3/2 sqrt(3) h apart

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

// Contract: a ray refers to the face that it meets first (nearest) or last (farthest); the raster fills as
// all pairs do; a point that does not meet the face of its ray gets no radius, any other the exact one.

TEST(TriangleTable, RaysStandInTheMiddleOfTheirPatches) {
  for (const std::size_t side : {1U, 7U, 10U}) {
    for (std::size_t ray = 0; ray < side * side; ++ray)
      EXPECT_EQ(ray_of(side, 3.0 * ray_direction(side, ray)), ray);
  }
  EXPECT_NEAR(angle_between(ray_direction(10, 0), Vec3::UnitZ()) / kDegree, 9.0, 1e-12);
  EXPECT_NEAR(to_angles(ray_direction(10, 1)).theta / kDegree, 54.0, 1e-12);
  EXPECT_EQ(ray_of(10, Vec3::UnitZ()), 0U);
  EXPECT_EQ(ray_of(10, -Vec3::UnitZ()), 90U) << "the poles belong to the outermost rows";
}

TEST(TriangleTable, RadiusOnAFaceIsThatOfTheRayCaster) {
  const BallSocketPair pair = make_ball_socket_pair(100);
  for (const TriangleMesh* mesh : {&pair.ball, &pair.socket}) {
    const RayCaster caster(*mesh);
    for (const Vec3& u : test::random_directions(300, 6)) {
      double met = std::nan("");
      for (const Face& face : mesh->faces) {
        const double radius = radius_on(*mesh, face, 7.0 * u);
        if (!std::isnan(radius)) met = radius;
      }
      const double expected = caster.cast(u, Layer::nearest);
      EXPECT_EQ(std::isnan(met), std::isnan(expected));
      if (std::isnan(met)) continue;
      EXPECT_NEAR(met, expected, 1e-11);
    }
  }
}

TEST(TriangleTable, TheRasterFillsAsAllPairsDo) {
  const BallSocketPair pair = make_ball_socket_pair(300, impinging_cam());
  TriangleMesh outer = pair.socket;
  for (Vec3& v : outer.vertices) v *= 1.1;
  const TriangleMesh two_layers = test::joined(pair.socket, outer);
  for (const TriangleMesh* mesh : {&pair.ball, &pair.socket, &two_layers}) {
    for (const Layer layer : {Layer::nearest, Layer::farthest}) {
      for (const std::size_t side : {1U, 2U, 10U, 37U})
        EXPECT_EQ(fill_triangles(*mesh, side, layer).face, fill_triangles_pairwise(*mesh, side, layer).face);
    }
  }
  EXPECT_NE(fill_triangles(two_layers, 37, Layer::nearest).face,
            fill_triangles(two_layers, 37, Layer::farthest).face);
  EXPECT_THROW(fill_triangles(two_layers, 0, Layer::nearest), std::invalid_argument);
}

TEST(TriangleTable, LosesFacesUntilEachHasARay) {
  const TriangleMesh ball = icosphere(22.0, 2);  // 320 faces, about 10 degrees wide
  const auto missed = [&ball](std::size_t side) {
    return missed_faces(fill_triangles(ball, side, Layer::farthest), ball);
  };
  EXPECT_GE(missed(10), 320U - 100U) << "no more faces than rays";
  EXPECT_GT(missed(20), 0U);
  EXPECT_EQ(missed(200), 0U);
}

TEST(TriangleTable, ExactWhereTheFaceIsMetAndSilentElsewhere) {
  const TriangleMesh ball = make_ball_socket_pair(300).ball;
  const TriangleTable table = fill_triangles(ball, 24, Layer::farthest);
  const RayCaster caster(ball);
  int silent = 0;
  for (const Vec3& u : test::random_directions(1000, 2)) {
    const double radius = radius_at(table, ball, 5.0 * u);
    silent += std::isnan(radius) ? 1 : 0;
    if (std::isnan(radius)) continue;
    EXPECT_NEAR(radius, caster.cast(u, Layer::farthest), 1e-11);
  }
  EXPECT_GT(silent, 50);
  EXPECT_LT(silent, 950);
}

TEST(MacielTriangles, MissesAContactUnderATriangleThatItLost) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  Pose touching;
  touching.translation = Vec3(0.1, 0.2, 4.5);
  Pose free;
  free.translation = Vec3(0.1, 0.2, 1.0);
  MacielTriangles fine(pair.ball, pair.socket, fill_triangles(pair.ball, 400, Layer::farthest));
  EXPECT_TRUE(fine.touches(touching));
  EXPECT_FALSE(fine.touches(free));
  TriangleTable none{1, {kNoFace}};
  EXPECT_FALSE(MacielTriangles(pair.ball, pair.socket, none).touches(touching));
  EXPECT_EQ(fine.bytes(), 400U * 400U * 4U + pair.ball.vertices.size() * 24U + 300U * 12U);
}

// Contract, away from the rim: |field - signed distance| <= the bound of the distance grid; negative beyond
// the socket as the centre sees it.

constexpr double kSocket = 26.0;

TEST(CartesianField, IsTheSignedDistanceOfASphereInside) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const DistanceGridShape shape{32.0, 33};
  const CartesianField field(pair.ball, make_signed_field(pair.socket, shape));
  const GridField grid = make_signed_field(pair.socket, shape);
  for (const Vec3& u : test::random_directions(300, 7)) {
    if (u.z() < 0.3) continue;
    for (const double radius : {22.0, 25.0, 27.0, 30.0})
      EXPECT_NEAR(grid.at(radius * u), kSocket - radius, distance_grid_bound(shape) + 0.1) << u.transpose();
  }
  EXPECT_GT(grid.at(Vec3(0.0, 0.0, -30.0)), 0.0) << "nothing is beyond where no socket is";
  EXPECT_TRUE(std::isnan(grid.at(Vec3(0.0, 0.0, 33.0))));
  EXPECT_EQ(field.bytes(), 33U * 33U * 33U * 4U);
}

TEST(CartesianField, TouchesOnceAVertexIsThrough) {
  const BallSocketPair pair = make_ball_socket_pair(1000);
  const DistanceGridShape shape{32.0, 33};
  CartesianField field(pair.ball, make_signed_field(pair.socket, shape));
  for (const double moved : {0.0, 2.0, 3.2, 4.8, 6.0}) {
    Pose pose;
    pose.translation = Vec3(0.0, 0.0, moved);
    EXPECT_EQ(field.touches(pose), moved > 4.0) << moved;
  }
  double least = 1e9;
  for (const double d : field.distances()) least = std::min(least, d);
  EXPECT_NEAR(least, -2.0, distance_grid_bound(shape) + 0.1) << "of the last pose";
}

}  // namespace
}  // namespace impinge::lab
