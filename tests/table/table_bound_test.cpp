// SPDX-License-Identifier: GPL-3.0-or-later
// |table.radius_at(u) - radius of the mesh along u| <= table_bound(), along directions of every kind, for
// every scheme and both interpolants; and where a scheme tells patches no bound half as large would do.
#include "table/table_bound.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "support/bound_probes.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/turned.hpp"
#include "table/own_scheme.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

struct Scene {
  std::string name;
  TriangleMesh mesh;
  Layer layer;
};

std::vector<Scene> scenes() {
  const BallSocketPair pair = make_ball_socket_pair(120);
  return {{"ball", pair.ball, Layer::farthest},
          {"socket", pair.socket, Layer::nearest},
          {"offset sphere", sphere(22.0, 100, {12.0, 3.0, -9.0}), Layer::farthest}};
}

// The check of the whole file: the largest error found, in shares of the bound.
template <class Table>
double largest_share(const Scene& scene, const Table& table, const TableBound& bound,
                     const std::vector<Vec3>& probes) {
  const RayCaster oracle(scene.mesh);
  const auto error = [&](const Vec3& u) {
    const double found = std::abs(table.radius_at(u) - oracle.cast(u, scene.layer));
    return std::isnan(found) ? 0.0 : found;
  };
  return test::largest_error(error, probes, 0.5 * table.scheme().stencil_radius()) / bound.bound_mm;
}

template <class Table>
void expect_bound(const Scene& scene, const Table& table, const std::vector<Vec3>& probes, bool tight) {
  const std::string what = std::string(table.scheme().name) + " on the " + scene.name;
  const TableBound bound = table_bound(scene.mesh, table, scene.layer);
  const double share = largest_share(scene, table, bound, probes);
  EXPECT_LE(share, 1.0) << what;
  if (!tight) return;
  ASSERT_TRUE(std::isfinite(bound.bound_mm)) << what;
  // Half of the bound is violated: by what the search attained, and along its witness.
  EXPECT_GT(bound.attained_mm, 0.9 * bound.bound_mm) << what;
  EXPECT_GT(share, 0.5) << what;
  const double at_witness =
      std::abs(table.radius_at(bound.witness) - RayCaster(scene.mesh).cast(bound.witness, scene.layer));
  EXPECT_NEAR(at_witness, bound.attained_mm, 1e-6 * bound.bound_mm) << what;
  EXPECT_GE(bound.a_priori_mm, bound.bound_mm * (1.0 - 1e-12)) << what;
}

TEST(TableBound, HoldsAndIsTightForEverySchemeAndInterpolant) {
  for (const Scene& scene : scenes()) {
    test::every_scheme([&]<class S>() {
      const S scheme = S::with_precision(6.0);
      const std::vector<Vec3> probes = test::bound_probes(scene.mesh, scheme, 300);
      const auto table = fill_exact(scene.mesh, scheme, scene.layer);
      expect_bound(scene, table, probes, HasPatches<S>);
      if constexpr (PlaneExactScheme<S>)
        expect_bound(scene, InverseDepthTable<S>(table), probes, HasFlatPatches<S>);
    });
  }
}

// A tetrahedron whose upper edge passes the pole at `off` radians: parallels that are farther from it cross
// the edge twice, in wide cells at that.
Scene roof(double off) {
  TriangleMesh mesh;
  mesh.vertices = {{20, 0, 15}, {-20, 0, 15}, {0, 20, -15}, {0, -20, -15}};
  mesh.faces = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
  return {"roof", test::turned(mesh, off, Vec3::UnitX()), Layer::farthest};
}

// Before any patch is halved the bound holds as well, and may be used so.
TEST(TableBound, HoldsAPriori) {
  std::vector<Scene> all = scenes();
  for (const double off : {0.02, 0.05, 0.09, 0.15}) all.push_back(roof(off));
  for (const Scene& scene : all) {
    for (const double precision : {10.0, 3.0}) {
      const auto check = [&]<class S>(const S& scheme) {
        const auto table = fill_exact(scene.mesh, scheme, scene.layer);
        TableBound bound = table_bound(scene.mesh, table, scene.layer, {.budget = 0});
        EXPECT_EQ(bound.bound_mm, bound.a_priori_mm);
        EXPECT_LE(largest_share(scene, table, bound, test::bound_probes(scene.mesh, scheme, 500)), 1.0)
            << S::name << " at " << precision << " on the " << scene.name;
      };
      check(Rsid::with_precision(precision));
      check(Usid::with_precision(precision));
      check(OctahedralEqualArea::with_precision(precision));
    }
  }
}

// Where theory is sharp the bound a priori is, too, so that no constant of it could be half as large: a kink
// along the middle of cells costs its jump times h / 4, a face seen at a right angle r h^2 / 8 either way.
TEST(TableBound, ItsConstantsAreTheLeastThereAre) {
  const Rsid scheme = Rsid::with_precision(2.0);
  const Eigen::AngleAxisd half_a_cell(0.5 * scheme.spacing(), Vec3::UnitZ());
  const auto share = [&](const TriangleMesh& mesh) {
    const auto table = fill_exact(mesh, scheme, Layer::nearest);
    const TableBound bound = table_bound(mesh, table, Layer::nearest, {.budget = 0});
    const auto error = [&, oracle = RayCaster(mesh)](const Vec3& u) {
      const double found = std::abs(table.radius_at(u) - oracle.cast(u, Layer::nearest));
      return std::isnan(found) ? 0.0 : found;
    };
    return test::largest_error(error, test::bound_probes(mesh, scheme, 3000), 0.02) / bound.bound_mm;
  };
  TriangleMesh wedge;
  wedge.vertices = {{20, 0, -6}, {20, 0, 6}, {17, 8, 0}, {17, -8, 0}};
  wedge.faces = {{0, 2, 1}, {0, 1, 3}};
  TriangleMesh flat;
  flat.vertices = {{20, -3, -2}, {20, 3, -2}, {20, 0, 3}};
  flat.faces = {{0, 1, 2}};
  for (TriangleMesh* mesh : {&wedge, &flat}) {
    for (Vec3& v : mesh->vertices) v = half_a_cell * v;
  }
  EXPECT_LE(share(wedge), 1.0);
  EXPECT_GT(share(wedge), 0.6);
  EXPECT_LE(share(flat), 1.0);
  EXPECT_GT(share(flat), 0.6);
}

// A flat face that covers the sphere's view: inverse depths reproduce it, radii do not.
TEST(TableBound, IsThatOfRoundingWhereTheInterpolantIsExact) {
  const TriangleMesh mesh = test::large_flat_face(20.0, 50.0);
  const CubeGnomonic scheme = CubeGnomonic::with_precision(3.0);
  const auto table = fill_exact(mesh, scheme, Layer::nearest);
  EXPECT_GT(table_bound(mesh, table, Layer::nearest).attained_mm, 1e-3);
  const TableBound exact = table_bound(mesh, InverseDepthTable<CubeGnomonic>(table), Layer::nearest);
  EXPECT_GT(exact.bound_mm, 0.0);
  EXPECT_LT(exact.bound_mm, 1e-6);
}

// What no search looks at. On a sphere of many small faces chords, and not slopes, are what inverse depths
// cost: in the middle of a cell, half as far from a tap as the bound allows for, a fifth of the bound.
TEST(TableBound, OfFirstOrderHoldsForBothInterpolants) {
  const auto share = [](const Scene& scene, const auto& table, const std::vector<Vec3>& probes) {
    return largest_share(scene, table, first_order_bound(scene.mesh, table), probes);
  };
  for (const Scene& scene : scenes()) {
    const CubeGnomonic scheme = CubeGnomonic::with_precision(3.0);
    const auto table = fill_exact(scene.mesh, scheme, scene.layer);
    const std::vector<Vec3> probes = test::bound_probes(scene.mesh, scheme, 500);
    EXPECT_LE(share(scene, table, probes), 1.0) << scene.name;
    EXPECT_LE(share(scene, InverseDepthTable<CubeGnomonic>(table), probes), 1.0) << scene.name;
  }
  const Scene round{"sphere", sphere(22.0, 2000), Layer::nearest};
  const CubeGnomonic coarse = CubeGnomonic::with_precision(30.0);
  const auto table = fill_exact(round.mesh, coarse, round.layer);
  const std::vector<Vec3> probes = test::random_directions(300, 62);
  EXPECT_LE(share(round, table, probes), 1.0);
  const double of_chords = share(round, InverseDepthTable<CubeGnomonic>(table), probes);
  EXPECT_LE(of_chords, 1.0);
  EXPECT_GT(of_chords, 0.15);
}

// Second order on a plane: half of the precision, about a quarter of the bound. (A finer table comes nearer
// to the rim, where the plane is steeper.)
TEST(TableBound, FallsAsItShouldOnAPlane) {
  const TriangleMesh mesh = test::large_flat_face(20.0, 20.0);
  const auto check = [&]<class S>(const S& coarse, const S& fine) {
    const auto bound = [&](const S& scheme) {
      return table_bound(mesh, fill_exact(mesh, scheme, Layer::nearest), Layer::nearest).bound_mm;
    };
    const double ratio = bound(fine) / bound(coarse);
    EXPECT_GT(ratio, 0.22) << S::name;
    EXPECT_LT(ratio, 0.32) << S::name;
  };
  check(Rsid::with_precision(2.0), Rsid::with_precision(1.0));
  check(IcosahedralSine::with_precision(2.0), IcosahedralSine::with_precision(1.0));
}

// Between the gnomonic and the equi-angular one.
struct NewWarp {
  static constexpr std::string_view name = "cube_new";
  static constexpr std::string_view label = "Cube, new";
  static constexpr std::string_view citation = "a test";
  static constexpr double kAngle = 0.6;
  static constexpr double kLongestWay = 1.83;  // sqrt(2) 2 w / sin(2 w), and a little
  static double node(double t) { return std::abs(t) == 1.0 ? t : std::tan(kAngle * t) / std::tan(kAngle); }
  static double coordinate(double a) { return std::atan(std::tan(kAngle) * a) / kAngle; }
};

TEST(TableBound, HoldsForAWarpOfWhichNothingMoreIsTold) {
  using NewCube = CubeMap<NewWarp>;
  static_assert(PlaneExactScheme<NewCube> && !HasPatches<NewCube> && HasFlatPatches<NewCube>);
  for (const Scene& scene : scenes()) {
    const NewCube scheme = NewCube::with_precision(6.0);
    const std::vector<Vec3> probes = test::bound_probes(scene.mesh, scheme, 300);
    const auto table = fill_exact(scene.mesh, scheme, scene.layer);
    expect_bound(scene, table, probes, false);
    expect_bound(scene, InverseDepthTable<NewCube>(table), probes, true);
  }
}

TEST(TableBound, OfASchemeWithoutPatchesIsOfFirstOrder) {
  using Far = test::FarTap<CubeGnomonic>;
  static_assert(!HasPatches<Far>);
  const TriangleMesh mesh = cone();
  const Far scheme = Far::with_precision(3.0);
  const auto table = fill_exact(mesh, scheme, Layer::farthest);
  const TableBound bound = table_bound(mesh, table, Layer::farthest);
  const Scene scene{"cone", mesh, Layer::farthest};
  const double share = largest_share(scene, table, bound, test::bound_probes(mesh, scheme, 20000));
  EXPECT_LE(share, 1.0);
  EXPECT_GT(share, 0.5);  // so that exp(T s / 2) in place of exp(T s) is found out
}

// On a small face that is seen at 45 degrees the slope hardly changes, and the tap is as far away as it may
// be: nine tenths of the bound would not do.
TEST(TableBound, OfFirstOrderIsSharpWhereTheSlopeIsConstant) {
  using Far = test::FarTap<CubeGnomonic>;
  const auto on_plane = [](double a, double b) -> Vec3 {  // through (0, 0, 20)
    return 20.0 * std::sqrt(2.0) / (a + b + std::sqrt(2.0)) * Vec3(a, b, 1.0);
  };
  const TriangleMesh mesh{{on_plane(-0.03, -0.03), on_plane(0.06, -0.03), on_plane(-0.03, 0.06)},
                          {{0, 1, 2}}};
  const Far scheme = Far::with_precision(0.5);
  const auto table = fill_exact(mesh, scheme, Layer::nearest);
  const Scene scene{"face", mesh, Layer::nearest};
  const double share =
      largest_share(scene, table, first_order_bound(mesh, table), test::bound_probes(mesh, scheme, 0));
  EXPECT_LE(share, 1.0);
  EXPECT_GT(share, 0.92);
}

}  // namespace
}  // namespace impinge
