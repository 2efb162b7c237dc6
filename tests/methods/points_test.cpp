// SPDX-License-Identifier: GPL-3.0-or-later
// Contract, every method against brute force:
//   radial     the nearest crossing of the ray through the point, NaN where there is none
//   euclidean  the least distance from any triangle
//   pose       the least distance between two triangles, of either surface
#include "methods/points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "mesh/jump_edges.hpp"
#include "mesh/triangle_distance.hpp"
#include "methods/contact.hpp"
#include "methods/gaps.hpp"
#include "methods/grid_field.hpp"
#include "methods/pose_set.hpp"
#include "methods/table_query.hpp"
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

std::vector<double> answers(const PointQuery& query, const std::vector<Vec3>& points) {
  std::vector<double> out(points.size());
  query.answer(points, out);
  return out;
}

// Without tables.
std::vector<PointCase> all_cases(const BenchmarkScene& scene, std::size_t nodes = 24) {
  return cases_of(points_methods(), &Method::points, scene, {{}, {nodes}});
}

PointCase case_of(const BenchmarkScene& scene, std::string_view name, std::string_view setting = "") {
  for (const PointCase& one : all_cases(scene)) {
    if (one.name == name && one.setting == setting) return one;
  }
  throw std::out_of_range(std::string(name));
}

// What asks point by point: vertices of the ball against a socket.
std::vector<GapCase> gap_cases(const TriangleMesh& mesh, Layer layer) {
  std::vector<GapCase> cases =
      cases_of(gaps_methods(), &Method::gaps, AskedSurface{mesh, layer, Surface::ball}, GapSizes{{}, {}});
  std::erase_if(cases, [](const GapCase& one) { return one.kernel || one.storage == "double"; });
  return cases;
}

// Is the direction so near to the rim that rounding decides whether the surface is met?
bool is_at_rim(const TriangleMesh& mesh, const Vec3& x) {
  return std::ranges::any_of(jump_edges(mesh), [&](const JumpEdge& edge) {
    return squared_distance_to_segment(mesh.vertices[edge.from].norm() * x.normalized(),
                                       mesh.vertices[edge.from], mesh.vertices[edge.to]) < 0.01;
  });
}

TEST(RadialMethods, FindTheNearestCrossing) {
  const BenchmarkScene scene = small_scene();
  const RayCaster caster(scene.surface());
  const std::vector<Vec3> points = points_of(scene);
  int methods = 0;
  for (const PointCase& one : all_cases(scene)) {
    if (one.measure != Measure::radial || one.setting == "fast") continue;
    ++methods;
    const std::vector<double> out = answers(one.make(), points);
    int met = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (is_at_rim(scene.surface(), points[i])) continue;
      const double radius = caster.cast(points[i].normalized(), Layer::nearest);
      ASSERT_EQ(std::isnan(out[i]), std::isnan(radius)) << one.name << ' ' << points[i].transpose();
      if (std::isnan(radius)) continue;
      ++met;
      EXPECT_NEAR(out[i], radius, one.in_float ? kFloat : kDouble) << one.name;
    }
    EXPECT_GT(met, 200);
  }
  EXPECT_EQ(methods, 5) << "three of Embree, CGAL and all pairs";
}

// The last packet is not full; what was in the places before must not be taken for rays.
TEST(RadialMethods, PacketsTakeAnyNumberOfRays) {
  const BenchmarkScene scene = small_scene();
  const PointQuery single = case_of(scene, "embree_ray1", "robust").make();
  for (const char* name : {"embree_ray8", "embree_ray16"}) {
    const PointQuery packets = case_of(scene, name, "robust").make();
    for (const std::size_t count : {1U, 7U, 9U, 17U}) {
      std::vector<Vec3> points(count, Vec3(0.3, 0.2, 20.0));
      points.back() = Vec3(0.0, 0.1, -5.0);
      const std::vector<double> out = answers(packets, points);
      EXPECT_TRUE(std::isnan(out.back()) || count == 1) << name << ' ' << count;
      for (std::size_t i = 0; i + 1 < count; ++i)
        EXPECT_NEAR(out[i], answers(single, {points[i]}).front(), kFloat);
    }
  }
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
  int methods = 0;
  for (const PointCase& one : all_cases(scene)) {
    if (one.measure != Measure::euclidean || one.bound) continue;
    ++methods;
    const auto out = answers(one.make(), points);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(out[i], distance_by_force(scene.surface(), points[i]),
                  one.name.starts_with("embree") ? kFloat : kDouble);
  }
  EXPECT_EQ(methods, 2) << "Embree and CGAL";
}

// The surface, and once more a fifth farther out.
TriangleMesh two_layers(TriangleMesh mesh) {
  const auto count = static_cast<VertexIndex>(mesh.vertices.size());
  for (VertexIndex i = 0; i < count; ++i) mesh.vertices.emplace_back(1.2 * mesh.vertices[i]);
  const std::vector<Face> faces = mesh.faces;
  for (const Face& face : faces) mesh.faces.push_back({face[0] + count, face[1] + count, face[2] + count});
  return mesh;
}

// Contract: the radius of the layer that is asked less the length of the point, or the distance. Behind a
// point of the rim there is the other side of the surface, which a ray from beyond must not answer.
TEST(GapMethods, AskPointByPointAsTheirQueriesDo) {
  const BenchmarkScene scene = small_scene();
  const AskedPoints asked(points_of(scene));
  const TriangleMesh mesh = two_layers(scene.surface());
  const RayCaster caster(mesh);
  std::size_t methods = 0;
  for (const Layer layer : {Layer::nearest, Layer::farthest}) {
    for (const GapCase& one : gap_cases(mesh, layer)) {
      ++methods;
      GapScratch scratch;
      const GapQuery query = one.make();
      query.scan(asked, {}, scratch);
      int within = 0;
      for (std::size_t i = 0; i < asked.points.size(); ++i) {
        const Vec3& x = asked.points[i];
        if (is_at_rim(mesh, x)) continue;
        const double expected = query.measure == Measure::euclidean
                                    ? distance_by_force(mesh, x)
                                    : caster.cast(x.normalized(), layer) - x.norm();
        EXPECT_EQ(std::isnan(scratch.gap(i)), std::isnan(expected)) << one.name;
        if (std::isnan(expected)) continue;
        ++within;
        EXPECT_NEAR(scratch.gap(i), expected, 2.0 * kFloat) << one.name;
      }
      EXPECT_GT(within, 50) << one.name;
    }
  }
  EXPECT_EQ(methods, 12U) << "of each layer: three of Embree's rays, its closest point, two of CGAL";
}

TEST(DistanceGrid, KeepsItsBoundAndNotHalfOfIt) {
  const BenchmarkScene scene = small_scene();
  const PointCase grid = case_of(scene, "distance_grid", "grid 24");
  const PointQuery query = grid.make();
  EXPECT_EQ(query.bytes, 24.0 * 24.0 * 24.0 * 4.0);
  // The error is largest over the surface, where the distance has its kink: points of the faces.
  std::vector<Vec3> points = points_of(scene);
  for (const Face& face : scene.surface().faces) {
    const TriangleCone cone = cone_of(scene.surface(), face);
    const auto& [a, b, c] = cone.corners();
    for (int i = 0; i <= 12; ++i) {
      for (int j = 0; i + j <= 12; ++j) points.emplace_back(a + (i * (b - a) + j * (c - a)) / 12.0);
    }
  }
  const auto out = answers(query, points);
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    largest = std::max(largest, std::abs(out[i] - distance_by_force(scene.surface(), points[i])));
  EXPECT_LE(largest, grid.bound(query).bound_mm);
  EXPECT_GT(largest, 0.5 * grid.bound(query).bound_mm);
}

TEST(DistanceGrid, HasNoAnswerOutsideAndRefusesWhatIsNoGrid) {
  const auto zero = [](const std::vector<Vec3>&, std::vector<double>& out) { std::ranges::fill(out, 0.0); };
  const GridField grid({30.0, 4}, zero);
  EXPECT_TRUE(std::isnan(grid.at(Vec3(0.0, 30.1, 0.0))));
  EXPECT_EQ(grid.at(Vec3(30.0, 30.0, 30.0)), 0.0);
  EXPECT_THROW(GridField({30.0, 1}, zero), std::invalid_argument);
  EXPECT_THROW(GridField({0.0, 8}, zero), std::invalid_argument);
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

ContactQuery contact_of(const BallSocketPair& pair, std::string_view name) {
  const auto cases = cases_of(contact_methods(), &Method::contact, pair);
  return std::ranges::find(cases, name, &ContactCase::name)->make();
}

// Over many poses FCL's smallest distance is not above that of any vertex, and 0 where a vertex is through.
TEST(PoseMethods, AgreeWithTheDistancesOfTheVertices) {
  BenchmarkScene scene = small_scene();
  for (const double moved : {0.0, 0.5, 3.0, 6.0}) {
    scene.pose.translation = Vec3(0.0, 0.0, moved);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& x : scene.queries()) least = std::min(least, distance_by_force(scene.surface(), x));
    const double distance = contact_of(scene.pair, "fcl_distance").smallest(scene.pose);
    EXPECT_EQ(contact_of(scene.pair, "fcl_collide").touches(scene.pose), distance == 0.0) << moved;
    EXPECT_EQ(distance == 0.0, moved == 6.0);
    EXPECT_LE(distance, least + kDouble);
    EXPECT_NEAR(distance, surface_distance(scene), kDouble) << "moved by " << moved;
  }
}

TEST(TableQuery, AnswersAsTheTableAndCountsItsBytes) {
  const BenchmarkScene scene = small_scene();
  const RadialTable<Rsid> table = fill_exact(scene.surface(), Rsid::with_precision(2.0), Layer::nearest);
  const std::vector<Vec3> points = points_of(scene);
  const PointQuery method = table_query(table);
  const PointQuery stored = table_query(Uint16Table<Rsid>(table));
  const auto out = answers(method, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = table.radius_at(points[i]);
    EXPECT_TRUE(out[i] == radius || (std::isnan(out[i]) && std::isnan(radius)));
  }
  const auto rim = static_cast<double>(table.rim_cells().bytes());
  EXPECT_GT(rim, 0.0);
  EXPECT_EQ(method.bytes, 8.0 * static_cast<double>(table.scheme().size()) + rim);
  EXPECT_EQ(stored.bytes, 2.0 * static_cast<double>(table.scheme().size()) + rim);
  EXPECT_EQ(method.storage_bound, 0.0);
  EXPECT_GT(stored.storage_bound, 0.0);
}

// Libraries keep at least the triangles in float; a sanitizer's allocator does not count.
TEST(Bytes, OfLibrariesAreThoseOfTheirTrees) {
  const BenchmarkScene scene = small_scene();
  const double least = 300.0 * 9.0 * 4.0 / 3.0;
  for (const PointCase& one : all_cases(scene))
    EXPECT_FALSE(one.make().bytes <= least) << one.name << ": NaN where nobody counts";
  for (const GapCase& one : gap_cases(scene.surface(), Layer::nearest))
    EXPECT_FALSE(one.make().bytes <= least) << one.name;
}

}  // namespace
}  // namespace impinge::lab
