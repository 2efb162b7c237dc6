// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, every method against brute force:
//   radial     the nearest crossing of the ray through the point, NaN where there is none
//   euclidean  the least distance from any triangle
//   pose       the least distance between two triangles, of either surface
#include "methods/radius_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "mesh/jump_edges.hpp"
#include "mesh/triangle_distance.hpp"
#include "methods/cgal_distances.hpp"
#include "methods/distance_grid.hpp"
#include "methods/embree_closest.hpp"
#include "methods/embree_rays.hpp"
#include "methods/fcl_pose.hpp"
#include "methods/pairwise_rays.hpp"
#include "methods/surface_distance.hpp"
#include "methods/table_method.hpp"
#include "methods/vdb_distances.hpp"
#include "methods/vtk_distances.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/stored_table.hpp"
#include "support/directions.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kFloat = 1e-5;    // mm, of rays and triangles in float
constexpr double kDouble = 1e-11;  // mm

BenchmarkScene small_scene() {
  BenchmarkScene scene{"small", make_ball_socket_pair(300), {}};
  scene.pose.rotation = Eigen::AngleAxisd(-40.0 * kDegree, Vec3::UnitY()).toRotationMatrix();
  return scene;
}

// Vertices of the ball, and points in random directions.
std::vector<Vec3> points_of(const BenchmarkScene& scene) {
  std::vector<Vec3> points = scene.queries();
  for (const Vec3& u : test::random_directions(500, 4)) points.push_back(23.0 * u);
  return points;
}

std::vector<double> answers(RadiusMethod& method, const std::vector<Vec3>& points) {
  std::vector<double> out(points.size());
  method.answer(points, out);
  return out;
}

// Is the direction so near to the rim that rounding decides whether the surface is met?
bool is_at_rim(const TriangleMesh& mesh, const Vec3& x) {
  return std::ranges::any_of(jump_edges(mesh), [&](const JumpEdge& edge) {
    return squared_distance_to_segment(mesh.vertices[edge.from].norm() * x.normalized(),
                                       mesh.vertices[edge.from], mesh.vertices[edge.to]) < 0.01;
  });
}

void expect_the_nearest_crossing(RadiusMethod& method, double tolerance) {
  const BenchmarkScene scene = small_scene();
  const RayCaster caster(scene.surface());
  const std::vector<Vec3> points = points_of(scene);
  const std::vector<double> out = answers(method, points);
  int met = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_at_rim(scene.surface(), points[i])) continue;
    const double radius = caster.cast(points[i].normalized(), Layer::nearest);
    ASSERT_EQ(std::isnan(out[i]), std::isnan(radius)) << points[i].transpose();
    if (std::isnan(radius)) continue;
    ++met;
    EXPECT_NEAR(out[i], radius, tolerance);
  }
  EXPECT_GT(met, 200);
}

TEST(RadialMethods, FindTheNearestCrossing) {
  const TriangleMesh surface = small_scene().surface();
  for (const int width : {1, 8, 16})
    expect_the_nearest_crossing(*make_embree_rays(surface, {width, EmbreeQuality::robust}), kFloat);
  expect_the_nearest_crossing(*make_cgal_first_hit(surface), kDouble);
  expect_the_nearest_crossing(*make_vtk_first_hit(surface), kDouble);
  expect_the_nearest_crossing(*make_pairwise_rays(surface, Layer::nearest), kDouble);
}

// The last packet is not full; what was in the places before must not be taken for rays.
TEST(RadialMethods, PacketsTakeAnyNumberOfRays) {
  const TriangleMesh surface = small_scene().surface();
  const auto single = make_embree_rays(surface, {1, EmbreeQuality::robust});
  for (const int width : {8, 16}) {
    const auto packets = make_embree_rays(surface, {width, EmbreeQuality::robust});
    for (const std::size_t count : {1U, 7U, 9U, 17U}) {
      std::vector<Vec3> points(count, Vec3(0.3, 0.2, 20.0));
      points.back() = Vec3(0.0, 0.1, -5.0);
      const std::vector<double> out = answers(*packets, points);
      EXPECT_TRUE(std::isnan(out.back()) || count == 1) << width << ' ' << count;
      for (std::size_t i = 0; i + 1 < count; ++i)
        EXPECT_NEAR(out[i], answers(*single, {points[i]}).front(), kFloat);
    }
  }
  EXPECT_THROW(make_embree_rays(surface, {4, EmbreeQuality::fast}), std::invalid_argument);
}

double distance_by_force(const TriangleMesh& mesh, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const Face& face : mesh.faces) {
    least = std::min(least, squared_distance_to_triangle(x, corner(mesh, face, 0), corner(mesh, face, 1),
                                                         corner(mesh, face, 2)));
  }
  return std::sqrt(least);
}

// The oracle of the oracle: no point of a fine grid on the triangle is nearer, and one is as near.
TEST(TriangleDistance, IsThatOfTheNearestPoint) {
  const Vec3 a(0.0, 0.0, 1.0);
  const Vec3 b(2.0, 0.5, 1.2);
  const Vec3 c(0.3, 1.5, 0.7);
  constexpr int kSteps = 300;
  for (const Vec3& u : test::random_directions(60, 8)) {
    const Vec3 x = 3.0 * u + Vec3(0.5, 0.5, 1.0);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 p = a + (i * (b - a) + j * (c - a)) / kSteps;
        least = std::min(least, (x - p).norm());
      }
    }
    const double distance = std::sqrt(squared_distance_to_triangle(x, a, b, c));
    EXPECT_LE(distance, least + 1e-12);
    EXPECT_GE(distance, least - 0.01);
  }
  EXPECT_NEAR(squared_distance_to_triangle(Vec3(1.0, 1.0, 0.0), a, a, a), 3.0, 1e-14) << "a point";
}

TEST(EuclideanMethods, FindTheNearestPoint) {
  const BenchmarkScene scene = small_scene();
  const std::vector<Vec3> points = points_of(scene);
  const auto embree = answers(*make_embree_closest(scene.surface()), points);
  const auto cgal = answers(*make_cgal_closest(scene.surface()), points);
  const auto vtk = answers(*make_vtk_closest(scene.surface()), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = distance_by_force(scene.surface(), points[i]);
    EXPECT_NEAR(cgal[i], distance, kDouble);
    EXPECT_NEAR(vtk[i], distance, kDouble);
    EXPECT_NEAR(embree[i], distance, kFloat);
  }
}

TEST(DistanceGrid, KeepsItsBoundAndNotHalfOfIt) {
  const BenchmarkScene scene = small_scene();
  const DistanceGridShape shape = grid_shape(scene, 24);
  const auto grid = make_distance_grid(scene.surface(), shape);
  EXPECT_EQ(grid->bytes(), 24.0 * 24.0 * 24.0 * 4.0);
  // The error is largest over the surface, where the distance has its kink: points of the faces.
  std::vector<Vec3> points = points_of(scene);
  for (const Face& face : scene.surface().faces) {
    const TriangleCone cone = cone_of(scene.surface(), face);
    const auto& [a, b, c] = cone.corners();
    for (int i = 0; i <= 12; ++i) {
      for (int j = 0; i + j <= 12; ++j) points.emplace_back(a + (i * (b - a) + j * (c - a)) / 12.0);
    }
  }
  const auto out = answers(*grid, points);
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    largest = std::max(largest, std::abs(out[i] - distance_by_force(scene.surface(), points[i])));
  EXPECT_LE(largest, distance_grid_bound(shape));
  EXPECT_GT(largest, 0.5 * distance_grid_bound(shape));
}

TEST(DistanceGrid, HasNoAnswerOutsideAndRefusesWhatIsNoGrid) {
  const BenchmarkScene scene = small_scene();
  const auto grid = make_distance_grid(scene.surface(), {30.0, 4});
  EXPECT_TRUE(std::isnan(answers(*grid, {Vec3(0.0, 30.1, 0.0)}).front()));
  EXPECT_FALSE(std::isnan(answers(*grid, {Vec3(30.0, 30.0, 30.0)}).front()));
  EXPECT_THROW(make_distance_grid(scene.surface(), {30.0, 1}), std::invalid_argument);
  EXPECT_THROW(make_distance_grid(scene.surface(), {0.0, 8}), std::invalid_argument);
}

// Oracle of the oracle: all pairs of points on fine grids over two triangles.
TEST(TriangleDistance, OfTwoTrianglesIsThatOfTheirNearestPoints) {
  const auto grid = [](const Triangle& t) {
    constexpr int kSteps = 24;
    std::vector<Vec3> points;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j)
        points.emplace_back(t[0] + (i * (t[1] - t[0]) + j * (t[2] - t[0])) / kSteps);
    }
    return points;
  };
  const std::vector<Vec3> u = test::random_directions(6 * 30, 9);
  for (std::size_t k = 0; k < u.size(); k += 6) {
    const Triangle s{u[k], u[k + 1], u[k + 2]};
    const Vec3 aside(2.1, 0.4, 0.1);  // no two of them touch
    const Triangle t{u[k + 3] + aside, u[k + 4] + aside, u[k + 5] + aside};
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& p : grid(s)) {
      for (const Vec3& q : grid(t)) least = std::min(least, (p - q).norm());
    }
    const double distance = std::sqrt(squared_distance_of_triangles(s, t));
    EXPECT_LE(distance, least + 1e-12);
    EXPECT_GE(distance, least - 0.1);
    EXPECT_NEAR(std::sqrt(squared_distance_of_triangles(t, s)), distance, 1e-12);
  }
}

// Contract: |answer - distance| <= sqrt(3)/2 voxel, and NaN where the answer would be above the reach.
TEST(EuclideanMethods, AnswerNearTheSurfaceFromVoxels) {
  const BenchmarkScene scene = small_scene();
  const std::vector<Vec3> points = points_of(scene);
  for (const VdbShape shape : {VdbShape{1.0, 4.0}, VdbShape{0.5, 6.0}}) {
    const double bound = vdb_distance_bound(shape) + kFloat;
    EXPECT_NEAR(bound, 0.8660254 * shape.voxel_mm, 2.0 * kFloat);
    const auto out = answers(*make_vdb_distances(scene.surface(), shape), points);
    int within = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance = distance_by_force(scene.surface(), points[i]);
      if (std::abs(distance - shape.reach_mm) > bound) {
        EXPECT_EQ(std::isnan(out[i]), distance > shape.reach_mm) << distance;
      }
      if (std::isnan(out[i])) continue;
      ++within;
      EXPECT_LE(out[i], shape.reach_mm);
      EXPECT_NEAR(out[i], distance, bound);
    }
    EXPECT_GT(within, 50);
    EXPECT_LT(within, static_cast<int>(points.size()) - 50);
  }
  EXPECT_THROW(make_vdb_distances(scene.surface(), {0.0, 5.0}), std::invalid_argument);
  EXPECT_THROW(make_vdb_distances(scene.surface(), {0.5, -1.0}), std::invalid_argument);
}

// Over many poses FCL's smallest distance is not above that of any vertex, and 0 where a vertex is through.
TEST(PoseMethods, AgreeWithTheDistancesOfTheVertices) {
  BenchmarkScene scene = small_scene();
  for (const double moved : {0.0, 0.5, 3.0, 6.0}) {
    scene.pose.translation = Vec3(0.0, 0.0, moved);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& x : scene.queries()) least = std::min(least, distance_by_force(scene.surface(), x));
    const double distance = answers(*make_fcl_distance(scene), {Vec3::Zero()}).front();
    const double touch = answers(*make_fcl_collide(scene), {Vec3::Zero()}).front();
    EXPECT_EQ(touch == 0.0, distance == 0.0) << moved;
    EXPECT_EQ(distance == 0.0, moved == 6.0);
    EXPECT_LE(distance, least + kDouble);
    EXPECT_NEAR(distance, surface_distance(scene), kDouble) << "moved by " << moved;
  }
}

TEST(TableMethod, AnswersAsTheTableAndCountsItsBytes) {
  const BenchmarkScene scene = small_scene();
  const RadialTable<Rsid> table = fill_exact(scene.surface(), Rsid::with_precision(2.0), Layer::nearest);
  const std::vector<Vec3> points = points_of(scene);
  TableMethod<RadialTable<Rsid>> method(table);
  TableMethod<Uint16Table<Rsid>> stored{Uint16Table<Rsid>(table)};
  const auto out = answers(method, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = table.radius_at(points[i]);
    EXPECT_TRUE(out[i] == radius || (std::isnan(out[i]) && std::isnan(radius)));
  }
  const auto rim = static_cast<double>(table.rim_cells().bytes());
  EXPECT_GT(rim, 0.0);
  EXPECT_EQ(method.bytes(), 8.0 * static_cast<double>(table.scheme().size()) + rim);
  EXPECT_EQ(stored.bytes(), 2.0 * static_cast<double>(table.scheme().size()) + rim);
  EXPECT_EQ(method.storage_bound(), 0.0);
  EXPECT_GT(stored.storage_bound(), 0.0);
}

// Libraries keep at least the triangles in float; a sanitizer's allocator does not count.
TEST(Bytes, OfLibrariesAreThoseOfTheirTrees) {
  const BenchmarkScene scene = small_scene();
  const double least = 300.0 * 9.0 * 4.0 / 3.0;
  EXPECT_GT(make_embree_rays(scene.surface(), {})->bytes(), least);
  EXPECT_GT(make_embree_closest(scene.surface())->bytes(), least);
  EXPECT_GT(make_vdb_distances(scene.surface(), {})->bytes(), least);
  for (const auto& method :
       {make_cgal_first_hit(scene.surface()), make_cgal_closest(scene.surface()),
        make_pairwise_rays(scene.surface(), Layer::nearest), make_vtk_first_hit(scene.surface()),
        make_vtk_closest(scene.surface()), make_fcl_collide(scene), make_fcl_distance(scene)})
    EXPECT_FALSE(method->bytes() <= least) << "NaN where nobody counts";
}

}  // namespace
}  // namespace impinge::lab
