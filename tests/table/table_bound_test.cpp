// SPDX-License-Identifier: GPL-3.0-or-later
// |table.radius_at(u) - radius of the mesh along u| <= table_bound(), along directions of every kind, for
// every scheme and both interpolants; and where a scheme tells patches no bound half as large would do.
#include "table/table_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/jump_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/scheme.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"
#include "support/wrapped_scheme.hpp"
#include "table/own_scheme.hpp"
#include "table/pairwise.hpp"
#include "table/patch_error.hpp"
#include "table/surface_index.hpp"
#include "table/surface_kink.hpp"
#include "table/surface_plane.hpp"

namespace impinge {
namespace test {

// Directions along which a bound is put to the test, and a search for the worst one.

// Uniform ones, features of the mesh, poles and seam, both sides of the rim, the steepest face, and the
// entries themselves with directions next to them.
template <SamplingScheme S>
std::vector<Vec3> bound_probes(const TriangleMesh& mesh, const S& scheme, std::size_t uniform) {
  std::vector<Vec3> probes = random_directions(uniform, 60);
  for (const Vec3& u : test::feature_directions(mesh)) probes.push_back(u);
  for (const Vec3& x : special_directions()) probes.push_back(x.normalized());
  for (const JumpEdge& edge : jump_edges(mesh)) {
    const Vec3 middle = (mesh.vertices[edge.from] + mesh.vertices[edge.to]).normalized();
    const Vec3 across = mesh.vertices[edge.from].cross(mesh.vertices[edge.to]).normalized();
    for (const double off : {-0.05, -1e-3, -1e-9, 1e-9, 1e-3, 0.05})
      probes.push_back((middle + off * across).normalized());
  }
  const auto steepest = std::ranges::max_element(mesh.faces, {}, [&mesh](const Face& face) {
    const TriangleCone cone = cone_of(mesh, face);
    return cone.edge_on() ? 0.0 : cone.largest_slope();
  });
  for (const Vec3& u : random_directions(200, 61)) {
    const Vec3 weight = u.cwiseAbs();
    probes.push_back((weight[0] * corner(mesh, *steepest, 0) + weight[1] * corner(mesh, *steepest, 1) +
                      weight[2] * corner(mesh, *steepest, 2))
                         .normalized());
  }
  const std::size_t step = std::max<std::size_t>(scheme.size() / 500, 1);
  for (std::size_t i = 0; i < scheme.size(); i += step) {
    const Vec3 u = scheme.direction(i);
    probes.push_back(u);
    probes.push_back((u + 0.3 * scheme.stencil_radius() * u.unitOrthogonal()).normalized());
  }
  return probes;
}

// Largest error over the probes and over climbs from the worst of them; `step` is the first step, radians.
template <class Error>
double largest_error(const Error& error, const std::vector<Vec3>& probes, double step) {
  constexpr std::ptrdiff_t kClimbs = 12;
  std::vector<std::pair<double, std::size_t>> found(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i) found[i] = {error(probes[i]), i};
  const auto last = found.begin() + std::min(kClimbs, static_cast<std::ptrdiff_t>(found.size()));
  std::ranges::partial_sort(found, last, std::greater<>{});
  double largest = 0.0;
  for (auto start = found.begin(); start != last; ++start) {
    Vec3 u = probes[start->second];
    double here = start->first;
    for (double reach = step; reach > 1e-6 * step; reach *= 0.6) {
      const Vec3 east = u.unitOrthogonal();
      const Vec3 north = u.cross(east);
      for (int k = 0; k < 8; ++k) {
        const double angle = 0.25 * kPi * k;
        const Vec3 v = (u + reach * (std::cos(angle) * east + std::sin(angle) * north)).normalized();
        const double there = error(v);
        if (there > here) {
          here = there;
          u = v;
        }
      }
    }
    largest = std::max(largest, here);
  }
  return largest;
}

// One face on the plane x = distance that takes in a circle of about `opening` degrees round +x.
inline TriangleMesh large_flat_face(double distance, double opening) {
  TriangleMesh mesh;
  const double reach = 2.0 * distance * std::tan(opening * kDegree);
  mesh.vertices = {{distance, -reach, -reach},
                   {distance, 1.9 * reach, -0.3 * reach},
                   {distance, -0.4 * reach, 1.8 * reach}};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

// A scheme whose stencil is the tap that is farthest from the direction: nothing but the stencil radius says
// how wrong it is. It declares no patches.
template <SamplingScheme S>
class FarTap : public Wrapped<S> {
 public:
  static constexpr bool kFlatCells = S::kFlatCells;
  static FarTap with_precision(double degrees) {
    FarTap scheme;
    scheme.hold(S::with_precision(degrees));
    return scheme;
  }
  Stencil stencil(const Vec3& x) const {
    Stencil stencil = Wrapped<S>::stencil(x);
    const Vec3 u = x.normalized();
    const auto farther = [&](std::size_t a, std::size_t b) {
      return this->direction(a).dot(u) > this->direction(b).dot(u);
    };
    const std::size_t far = *std::max_element(stencil.entry.begin(), stencil.entry.begin() + 4, farther);
    return {{far, far, far, far}, {1.0, 0.0, 0.0, 0.0}, 1, stencil.cell};
  }
};

}  // namespace test

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

TEST(TheoremTable, HoldsAndIsTightForEverySchemeAndInterpolant) {
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
TEST(TheoremTable, HoldsAPriori) {
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
TEST(TheoremTable, ItsConstantsAreTheLeastThereAre) {
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
TEST(TheoremSlope, OfFirstOrderHoldsForBothInterpolants) {
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

TEST(TheoremTable, HoldsForAWarpOfWhichNothingMoreIsTold) {
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
TEST(TheoremSlope, OfFirstOrderIsSharpWhereTheSlopeIsConstant) {
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

// Contract: rounding takes nothing from what a bound is made of, at the ends of ranges and where digits
// cancel. Held against long double:
//   tan psi within a cap <= range_within().slope, radii within [least, largest]
//   an edge that enters a cap meets() it
// And a bound above the radius of the surface is none. An entry is moved by rounding as far as
// direction_doubt() says, and bounds hold from there.

using Exact = Eigen::Matrix<long double, 3, 1>;
using test::Dice;

// A face round a direction u, square to it but for 1e-12 to 1e-2 radians, and a cap about as small beside u.
TEST(TheoremTable, APlaneSeenAtARightAngleHasItsSlope) {
  Dice dice(19);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 u = dice.direction();
    const Vec3 east = u.unitOrthogonal();
    const Vec3 north = u.cross(east);
    const double tilt = dice.power(-12.0, -2.0);
    const auto on_plane = [&](double a, double b) -> Vec3 {
      return 20.0 * u + a * (east + tilt * u) + b * north;
    };
    const TriangleCone cone(on_plane(-9, -8), on_plane(9, -7), on_plane(1, 9));
    const SurfacePlane plane = surface_plane(cone);
    const DirectionCap cap{(u + dice.power(-12.0, -2.0) * east).normalized(), dice.power(-12.0, -2.0)};
    const PlaneRange range = range_within(plane, cap);
    const auto& v = cone.corners();
    const Exact a = v[0].cast<long double>();
    const Exact normal = (v[1].cast<long double>() - a).cross(v[2].cast<long double>() - a);
    const Exact axis = cap.axis.cast<long double>().normalized();
    const long double reach = static_cast<long double>(cap.radius) * (1.0L - 1e-15L);
    for (int side = 0; side < 4; ++side) {
      const Exact way = ((side < 2 ? 1.0 : -1.0) * (side % 2 == 0 ? east : north)).cast<long double>();
      const Exact across = (way - way.dot(axis) * axis).normalized();
      const Exact x = std::cos(reach) * axis + std::sin(reach) * across;
      const long double along = normal.dot(x);
      const auto slope = normal.cross(x).norm() / std::abs(along);
      const auto radius = normal.dot(a) / along * x.norm();
      ASSERT_LE(slope, static_cast<long double>(range.slope)) << tilt << ' ' << cap.radius;
      ASSERT_GE(radius, static_cast<long double>(range.least)) << tilt << ' ' << cap.radius;
      ASSERT_LE(radius, static_cast<long double>(range.largest)) << tilt << ' ' << cap.radius;
    }
  }
}

// Edges from 1e-9 to 1 radian, and a cap that the middle of the edge is only just in; sideways, where the
// normal of the edge decides.
TEST(TheoremTable, AShortEdgeMeetsACapThatItEnters) {
  Dice dice(19);
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const Vec3 from = 20.0 * dice.direction();
    const Vec3 to = from + 20.0 * dice.power(-9.0, -0.3) * dice.direction();
    const auto kink = surface_kink(from, to, Vec3::UnitX());
    if (!kink) continue;
    const Exact a = from.cast<long double>();
    const Exact along = to.cast<long double>() - a;
    const Exact normal = a.cross(along).normalized();
    const Exact middle = (a + 0.5L * along).normalized();
    const long double aside = static_cast<long double>(dice.power(-11.0, -3.0));
    const Exact exact = std::cos(aside) * middle + std::sin(aside) * normal;
    const Vec3 axis = exact.cast<double>();
    const long double distance =
        std::atan2(axis.cast<long double>().cross(middle).norm(), axis.cast<long double>().dot(middle));
    ASSERT_TRUE(meets(*kink, {axis, static_cast<double>(distance * (1.0L + 1e-15L))}))
        << (to - from).norm() << ' ' << static_cast<double>(aside);
  }
}

TEST(BoundRounding, ABoundAboveTheSurfaceIsNone) {
  using Far = test::FarTap<CubeGnomonic>;
  const TriangleMesh mesh = cone();
  for (const double precision : {1.0, 45.0}) {
    const auto table = fill_exact(mesh, Far::with_precision(precision), Layer::farthest);
    const TableBound bound = table_bound(mesh, table, Layer::farthest);
    EXPECT_EQ(std::isinf(bound.bound_mm), precision > 1.0) << bound.bound_mm;
    EXPECT_EQ(std::isinf(bound.a_priori_mm), precision > 1.0);
  }
}

// What the header derives: an azimuth of t turns has 8 roundings.
double rounding_of_turns(std::size_t turns) { return 8.0 * 0x1p-53 * 2.0 * kPi * static_cast<double>(turns); }

TEST(DirectionDoubt, IsNoLessThanTheRoundingOfAllTurns) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(2.0);
    EXPECT_GE(direction_doubt(scheme), rounding_of_turns(scheme.equator_points() + 1)) << S::name;
  });
}

// A curve of a million turns, whose stencils are one entry that is as near as this.
class ManyTurns : public test::Wrapped<Rsid> {
 public:
  static constexpr std::size_t kTurns = 1'000'000;
  static constexpr double kNear = 1e-9;  // radians
  static ManyTurns with_precision(double degrees) {
    ManyTurns scheme;
    scheme.hold(Rsid::with_precision(degrees));
    return scheme;
  }
  double stencil_radius() const { return kNear; }
  std::size_t equator_points() const { return kTurns; }
  Stencil stencil(const Vec3& x) const {
    const Stencil all = test::Wrapped<Rsid>::stencil(x);
    const std::size_t near = all.entry[static_cast<std::size_t>(
        std::max_element(all.weight.begin(), all.weight.end()) - all.weight.begin())];
    return {{near, near, near, near}, {1.0, 0.0, 0.0, 0.0}, 1, all.cell};
  }
};

// A slope of 45 degrees seen from an entry, along a direction that is farther than the stencil radius from it
// by what rounding may have moved the entry.
TEST(DirectionDoubt, ABoundHoldsForAnEntryThatRoundingHasMoved) {
  const auto scheme = ManyTurns::with_precision(10.0);
  const Vec3 u = scheme.direction(scheme.stencil(Vec3(1.0, 2.0, 3.0)).entry[0]);
  const Vec3 level = Vec3::UnitZ().cross(u).normalized();  // along the rows of the grid, as are the rims
  const Vec3 down = u.cross(level);
  const auto corner = [&](double a, double b) -> Vec3 { return 20.0 * u + a * (down - u) + b * level; };
  const TriangleMesh mesh{{corner(-0.2, -0.2), corner(0.3, -0.2), corner(0.3, 0.2), corner(-0.2, 0.2)},
                          {{0, 1, 2}, {0, 2, 3}}};
  const auto table = fill_exact(mesh, scheme, Layer::nearest);
  const double moved = ManyTurns::kNear + rounding_of_turns(ManyTurns::kTurns);
  const Exact x =
      u.cast<long double>() - std::tan(static_cast<long double>(moved)) * down.cast<long double>();
  const Exact normal = (u + down).cast<long double>();
  const auto truth =
      static_cast<double>(normal.dot(20.0L * u.cast<long double>()) / normal.dot(x) * x.norm());
  const double error = std::abs(table.radius_at(x.cast<double>()) - truth);
  EXPECT_GT(error, 0.99 * 20.0 * moved);
  EXPECT_LE(error, error_bound_at(table, largest_slopes(mesh, scheme), x.cast<double>()));
  EXPECT_LE(error, table_bound(mesh, table, Layer::nearest).bound_mm);
}

// The error of a patch that is one direction is that of a direction a little aside.
TEST(DirectionDoubt, APatchHasItsShareOfTheSlope) {
  constexpr double kDoubt = 1e-6;
  const TriangleMesh mesh{{{21, -1, -1}, {19, 1, -1}, {20, 0, 2}}, {{0, 1, 2}}};  // 45 degrees
  const SurfaceIndex surface(mesh, Layer::nearest, 0.01);
  PatchView view;
  view.motion.smooth = true;
  view.cap = {Vec3::UnitX(), 1e-9};
  view.point.fill(Vec3::UnitX());
  view.corner.fill({20.0, 20.0});
  view.least_tap = view.largest_tap = 20.0;
  EXPECT_GE(PatchError(surface, kDoubt)(view).bound, 20.0 * kDoubt);
}

}  // namespace
}  // namespace impinge
