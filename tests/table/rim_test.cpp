// SPDX-License-Identifier: GPL-3.0-or-later
// No interpolation across a rim: where the surface ends or jumps inside a cell, the cell has no surface.
#include "table/rim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/stored_table.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"
#include "table/error_bound.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

// A sphere with one face missing, far smaller than a cell of the table.
TriangleMesh with_small_hole() {
  TriangleMesh mesh = sphere(22.0, 20000);
  mesh.faces.erase(mesh.faces.begin() + 7002);
  return mesh;
}

TEST(Rim, AHoleBetweenEntriesIsMasked) {
  const TriangleMesh whole = sphere(22.0, 20000);
  const Face& face = whole.faces[7002];
  const Vec3 into_hole =
      (corner(whole, face, 0) + corner(whole, face, 1) + corner(whole, face, 2)).normalized();
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(5.0);
    const auto table = fill_exact(with_small_hole(), scheme, Layer::nearest);
    if (HasKnownBorders<S>) {
      EXPECT_EQ(std::ranges::count_if(table.radii(), [](double r) { return std::isnan(r); }), 0) << S::name;
    }
    EXPECT_TRUE(std::isnan(table.radius_at(into_hole))) << S::name;
    EXPECT_FALSE(std::isnan(fill_exact(whole, scheme, Layer::nearest).radius_at(into_hole))) << S::name;
  });
}

// A direction outside of the surface never gets a radius, however near to the rim it is.
TEST(Rim, NothingIsMetOutsideOfTheRim) {
  const TriangleMesh socket = make_ball_socket_pair(3000).socket;
  const RayCaster oracle(socket);
  std::vector<Vec3> near_rim;
  for (const JumpEdge& edge : jump_edges(socket)) {
    const Vec3 middle = (socket.vertices[edge.from] + socket.vertices[edge.to]).normalized();
    for (const double off : {1e-9, 1e-6, 1e-4, 1e-3, 0.01})
      near_rim.push_back((middle - Vec3(0, 0, off)).normalized());
  }
  test::every_scheme([&]<class S>() {
    const auto table = fill_exact(socket, S::with_precision(1.0), Layer::nearest);
    for (const Vec3& u : near_rim) {
      ASSERT_TRUE(std::isnan(oracle.cast(u, Layer::nearest)));
      EXPECT_TRUE(std::isnan(table.radius_at(u))) << S::name << ' ' << u.transpose();
    }
  });
}

// Within 8 degrees of the rim of a surface.
std::vector<Vec3> directions_near_the_rim(const TriangleMesh& mesh, std::size_t count) {
  std::vector<Vec3> directions;
  const std::vector<JumpEdge> rim = jump_edges(mesh);
  for (const Vec3& off : test::random_directions(count, 32)) {
    const JumpEdge& edge = rim[directions.size() % rim.size()];
    const Vec3 middle = (mesh.vertices[edge.from] + mesh.vertices[edge.to]).normalized();
    directions.push_back((middle + std::abs(off.x()) * 8.0 * kDegree * off).normalized());
  }
  return directions;
}

// Nor with the other interpolant, whose taps are those of a neighbour beside the curved cells of one scheme.
TEST(Rim, MeshExactReachesAcrossNoRimEither) {
  const TriangleMesh mesh = test::askew(make_ball_socket_pair(3000).socket);
  const RayCaster oracle(mesh);
  const auto directions = directions_near_the_rim(mesh, 10000);
  std::vector<double> truth;
  for (const Vec3& u : directions) truth.push_back(oracle.cast(u, Layer::nearest));
  test::every_scheme([&]<class S>() {
    if constexpr (PlaneExactScheme<S>) {
      const RadialTable<S> smooth = fill_exact(mesh, S::with_precision(4.0), Layer::nearest);
      const InverseDepthTable<S> table(smooth);
      for (std::size_t k = 0; k < directions.size(); ++k) {
        const double radius = table.radius_at(directions[k]);
        if (std::isnan(radius)) continue;
        ASSERT_NEAR(radius, truth[k], 0.5) << S::name << " at " << directions[k].transpose();
      }
    }
  });
}

// Less than two cells inside of the rim the surface is there again.
TEST(Rim, TheMaskIsNoWiderThanItMustBe) {
  const TriangleMesh socket = make_ball_socket_pair(3000).socket;
  test::every_scheme([&]<class S>() {
    const S scheme = S::with_precision(1.0);
    const auto table = fill_exact(socket, scheme, Layer::nearest);
    const double inside = 87.0 * kDegree - 2.5 * scheme.stencil_radius();
    for (double theta = 0.0; theta < 2.0 * kPi; theta += 0.01) {
      EXPECT_FALSE(std::isnan(table.radius_at(to_direction({inside, theta})))) << S::name << ' ' << theta;
    }
  });
}

// A notch between two rows of entries, open along the grid line theta = 0: on the line itself the entries
// above and below it must not be joined either.
TEST(Rim, ANotchOnAGridLineIsNotBridged) {
  TriangleMesh mesh = sphere(22.0, 20000);
  std::erase_if(mesh.faces, [&](const Face& face) {
    const auto [phi, theta] =
        to_angles(corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2));
    const double off = std::abs(std::remainder(theta, 2.0 * kPi));
    return std::abs(phi - 45.0 * kDegree) < 3.0 * kDegree && off < 14.0 * kDegree;
  });
  const auto table = fill_exact(mesh, Rsid::with_precision(10.0), Layer::nearest);
  EXPECT_TRUE(std::isnan(table.radius_at(to_direction({45.0 * kDegree, 0.0}))));
  EXPECT_FALSE(std::isnan(table.radius_at(to_direction({65.0 * kDegree, 0.0}))));
}

TEST(Rim, AClosedBodyHasNone) {
  EXPECT_TRUE(jump_edges(sphere(22.0, 500)).empty());
  EXPECT_TRUE(jump_edges(make_ball_socket_pair(300).ball).empty());
}

TEST(Rim, AFoldIsAJump) {
  // A cup inside a larger one, joined by nothing: seen from the centre the near rim hides part of the far
  // cup.
  TriangleMesh mesh = test::joined(cup(20.0, 40.0, 400), cup(26.0, 80.0, 800));
  for (const double turn : {0.0, 0.7}) {  // along the rows of a grid, and across them
    for (Vec3& v : mesh.vertices) v = Eigen::AngleAxisd(turn, Vec3(1, 2, 3).normalized()) * v;
    const auto directions = test::random_directions(5000, 30);
    const RayCaster oracle(mesh);
    std::vector<double> truth;
    for (const Vec3& u : directions) truth.push_back(oracle.cast(u, Layer::nearest));
    test::every_scheme([&]<class S>() {
      const S scheme = S::with_precision(5.0);
      const auto table = fill_exact(mesh, scheme, Layer::nearest);
      const auto slopes = largest_slopes(mesh, scheme);
      for (std::size_t k = 0; k < directions.size(); ++k) {
        const Vec3& u = directions[k];
        const double radius = table.radius_at(u);
        if (std::isnan(radius)) continue;
        ASSERT_TRUE(std::abs(radius - 20.0) < 0.5 || std::abs(radius - 26.0) < 0.5)
            << S::name << ": " << radius << " mixes two layers";
        ASSERT_NEAR(radius, truth[k], error_bound_at(table, slopes, u) + 1e-11) << S::name;
      }
    });
  }
}

// A steep spike on a sphere, narrower than a cell, that rises beyond the rim of a flat cup: there the rim is
// seen, though the entries round it and the slope of the cup alone speak of a rim far behind the sphere.
TEST(Rim, ARimThatIsSeenBetweenEntriesOnAnObliqueMeshIsMasked) {
  const auto check = []<class S>(const S& scheme, const Vec3& spike) {
    TriangleMesh mesh = radial_body(200000, [&spike](const Vec3& u) {
      const double off = angle_between(u, spike) / kDegree;
      return 20.0 + 14.0 * std::exp(-off * off);
    });
    TriangleMesh rim = cup(30.0, 40.0, 2000);
    const Vec3 on_rim = to_direction({40.0 * kDegree, 0.0});
    const auto turn = Eigen::Quaterniond::FromTwoVectors(on_rim, spike);
    const auto shift = static_cast<VertexIndex>(mesh.vertices.size());
    for (const Vec3& v : rim.vertices) mesh.vertices.push_back(turn * v);
    for (const Face& f : rim.faces) mesh.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
    const RayCaster oracle(mesh);
    const double inside = oracle.cast(turn * to_direction({39.7 * kDegree, 0.0}), Layer::nearest);
    const double outside = oracle.cast(turn * to_direction({40.1 * kDegree, 0.0}), Layer::nearest);
    ASSERT_NEAR(inside, 30.0, 0.1);
    ASSERT_GT(outside, 32.0) << "the surface jumps at the rim";
    const auto table = fill_exact(mesh, scheme, Layer::nearest);
    EXPECT_TRUE(std::isnan(table.radius_at(spike))) << S::name << " answers " << table.radius_at(spike);
    EXPECT_FALSE(std::isnan(table.radius_at(-spike))) << S::name;
  };
  check(Rsid::with_precision(5.0), to_direction({72.5 * kDegree, 32.5 * kDegree}));
  check(IcosahedralGnomonic::with_precision(5.0), to_direction({70.0 * kDegree, 31.0 * kDegree}));
}

// A rim that is hidden behind the layer asked for takes nothing away from it.
TEST(Rim, AHiddenRimIsNotMasked) {
  const TriangleMesh mesh = test::joined(cup(26.0, 40.0, 400), sphere(20.0, 2000));
  const auto table = fill_exact(mesh, Rsid::with_precision(2.0), Layer::nearest);
  for (const Vec3& u : test::random_directions(5000, 31)) EXPECT_NEAR(table.radius_at(u), 20.0, 0.1);
}

// The same of the outer layer, whose rims may lie nearer to the centre; and one farther out is a jump.
TEST(Rim, OfTheFarthestLayerOnesNearerToTheCentreAreHidden) {
  for (const bool hidden : {true, false}) {
    const TriangleMesh mesh = test::joined(cup(hidden ? 16.0 : 26.0, 40.0, 400), sphere(20.0, 2000));
    const RayCaster oracle(mesh);
    const auto table = fill_exact(mesh, Rsid::with_precision(2.0), Layer::farthest);
    std::size_t masked = 0;
    for (const Vec3& u : test::random_directions(5000, 33)) {
      const double radius = table.radius_at(u);
      masked += std::isnan(radius) ? 1U : 0U;
      if (!std::isnan(radius)) {
        EXPECT_NEAR(radius, oracle.cast(u, Layer::farthest), 0.3);
      }
    }
    EXPECT_EQ(masked > 0, !hidden);
  }
}

// A cell with the longest sides of all, by the directions of its three entries.
std::array<Vec3, 3> widest_cell(const IcosahedralGnomonic& scheme) {
  std::array<Vec3, 3> widest;
  double longest = 0.0;
  for (const Vec3& u : test::random_directions(5000, 37)) {
    const Stencil stencil = scheme.stencil(u);
    const std::array<Vec3, 3> tap{scheme.direction(stencil.entry[0]), scheme.direction(stencil.entry[1]),
                                  scheme.direction(stencil.entry[2])};
    const double side = std::min(
        {angle_between(tap[0], tap[1]), angle_between(tap[1], tap[2]), angle_between(tap[2], tap[0])});
    if (side <= longest) continue;
    longest = side;
    widest = tap;
  }
  return widest;
}

// An edge comes into a cell over an entry, far behind the surface there, and falls as steeply as the surface
// rises to a peak in the middle of the opposite side, where the edge is seen before it leaves the cell. Where
// it enters the cell it is farther behind all entries than such slopes reach.
TEST(Rim, AnEdgeThatIsSeenOnlyAtItsLeastRadiusIsMasked) {
  const auto scheme = IcosahedralGnomonic::with_precision(5.0);
  const std::array<Vec3, 3> tap = widest_cell(scheme);
  const Vec3 peak = (0.02 * tap[0] + 0.49 * (tap[1] + tap[2])).normalized();
  const double half = 0.5 * angle_between(tap[1], tap[2]);
  const TriangleMesh surface = radial_body(200000, [&](const Vec3& u) {
    return 20.0 * std::exp(0.87 * std::max(0.0, 0.95 * half - angle_between(u, peak)));
  });
  const Vec3 towards = (tap[0] - tap[0].dot(peak) * peak).normalized();
  const auto on_edge = [&](double angle) -> Vec3 {  // from the peak; it rises by 40 degrees there
    const double rise = std::tan(40.0 * kDegree);
    const double way = std::tan(angle) / (1.0 - rise * std::tan(angle));
    return 20.0 * std::exp(0.65 * half) * (peak + way * (rise * peak + towards));
  };
  const Vec3 from = on_edge(angle_between(peak, tap[0]) + 0.3 * kDegree);
  const Vec3 to = on_edge(-0.4 * kDegree);
  const Vec3 aside = to.norm() * (tap[1] + 0.5 * (tap[1] - peak) - 0.4 * kDegree * towards).normalized();
  for (const bool back : {false, true}) {
    TriangleMesh mesh = surface;
    test::add_face(mesh, back ? to : from, back ? from : to, aside);
    ASSERT_LT(RayCaster(mesh).cast(on_edge(0.0) + 1e-3 * (tap[1] - peak), Layer::nearest),
              RayCaster(surface).cast(peak, Layer::nearest) - 0.02)
        << "the surface jumps at the edge";
    EXPECT_TRUE(std::isnan(fill_exact(mesh, scheme, Layer::nearest).radius_at(peak))) << back;
  }
}

// A rim along grid lines parts the cells on both of its sides.
TEST(Rim, AnEdgeOnAGridLineMasksBothSides) {
  TriangleMesh mesh = sphere(26.0, 2000);
  test::add_face(mesh, {20, 0, 0}, {0, 20, 0}, {0, 0, 20});
  const RayCaster oracle(mesh);
  const auto table = fill_exact(mesh, Rsid::with_precision(5.0), Layer::nearest);
  for (const double phi : {22.5, 47.5, 72.5}) {
    for (const double theta : {2.5, 87.5, 92.5, 357.5}) {
      const Vec3 u = to_direction({phi * kDegree, theta * kDegree});
      EXPECT_TRUE(std::isnan(table.radius_at(u))) << phi << ' ' << theta;
    }
    const Vec3 aside = to_direction({phi * kDegree, 350.0 * kDegree});
    EXPECT_NEAR(table.radius_at(aside), oracle.cast(aside, Layer::nearest), 0.1);
  }
}

// All cells in which a line spends more than a step, as found by very short steps.
TEST(Rim, ALineIsFollowedThroughEveryCell) {
  test::every_scheme([]<class S>() {
    if constexpr (HasKnownBorders<S>) {
      const S scheme = S::with_precision(5.0);
      const auto ends = test::random_directions(60, 34);
      for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
        // Half of them pass close to a pole, where cells are bent most.
        const Vec3 pole = Vec3(0.0, 0.0, k % 4 == 0 ? 1.0 : -1.0);
        const Vec3 from = (k % 3 == 0 ? Vec3(ends[k]) : Vec3(pole + 0.3 * ends[k])).normalized();
        const Vec3 to = (k % 3 == 0 ? Vec3(ends[k + 1]) : Vec3(pole + 0.3 * ends[k + 1])).normalized();
        std::set<std::size_t> visited;
        for_each_cell_along(scheme, RimLine{from, to},
                            [&](const Stencil& s, const Vec3&, const Vec3&) { visited.insert(s.cell); });
        const double step = 0.01 * scheme.covering_radius();
        const auto pieces = static_cast<int>(angle_between(from, to) / step) + 1;
        std::size_t last = scheme.cells();
        int stretch = 0;
        for (int i = 0; i <= pieces; ++i) {
          const std::size_t cell = scheme.stencil(from + static_cast<double>(i) / pieces * (to - from)).cell;
          stretch = cell == last ? stretch + 1 : 0;
          last = cell;
          if (stretch < 30) continue;
          ASSERT_TRUE(visited.contains(cell)) << S::name << " line " << k;
        }
      }
    }
  });
}

// An edge that passes the centre at any distance, and where no number tells how far along it: its directions
// are half of a great circle, in a plane that is known in whole numbers.
TEST(Rim, AnEdgeThatAllButMeetsTheCentreIsFollowedThroughEveryCell) {
  test::Dice dice(35);
  test::every_scheme([&]<class S>() {
    if constexpr (HasKnownBorders<S>) {
      const S scheme = S::with_precision(5.0);
      for (const int exponent : {-3, -20, -44, -48, -51, -52, -60, -200, -1000}) {
        const bool whole = exponent >= -48;  // else the sum is exact for it moves one coordinate, from 0
        const Vec3 from = whole ? Vec3(dice.whole(5, 31), 0, dice.whole(-31, 31))
                                : Vec3(dice.between(5.0, 31.0), 0.0, dice.between(-31.0, 31.0));
        const Vec3 off(whole ? dice.whole(-9, 9) : 0, dice.whole(1, 9), whole ? dice.whole(-9, 9) : 0);
        const Vec3 to = std::ldexp(1.0, exponent) * off - from;  // exact
        const Vec3 start = from.normalized();
        const Vec3 ahead = (off - off.dot(start) * start).normalized();
        std::set<std::size_t> visited;
        for_each_cell_along(scheme, RimLine{from, to},
                            [&](const Stencil& s, const Vec3&, const Vec3&) { visited.insert(s.cell); });
        const double end = angle_between(from, to);
        const int pieces = static_cast<int>(end / (0.01 * scheme.covering_radius()));
        std::size_t last = scheme.cells();
        int stretch = 0;
        for (int i = 0; i <= pieces; ++i) {
          const double angle = end * i / pieces;
          const std::size_t cell = scheme.stencil(std::cos(angle) * start + std::sin(angle) * ahead).cell;
          stretch = cell == last ? stretch + 1 : 0;
          last = cell;
          if (stretch < 30) continue;
          ASSERT_TRUE(visited.contains(cell)) << S::name << " 2^" << exponent << ' ' << angle;
        }
      }
    }
  });
}

// The face beyond that edge lies before a sphere: nothing is read across its rim.
TEST(Rim, NothingIsReadAcrossAnEdgeThatAllButMeetsTheCentre) {
  for (const double off : {1e-3, 3e-15, 1e-15, 1e-17, 1e-200}) {
    TriangleMesh mesh = sphere(40.0, 2000);
    test::add_face(mesh, {25.0, 0.0, 0.0}, {-25.0, off, 0.0}, {0.0, 0.0, 25.0});
    test::every_scheme([&]<class S>() {
      const auto table = fill_exact(mesh, S::with_precision(5.0), Layer::nearest);
      for (double angle = 0.1; angle < 3.1; angle += 0.1) {
        const Vec3 u(std::cos(angle), std::sin(angle), 1e-7);
        EXPECT_TRUE(std::isnan(table.radius_at(u))) << S::name << ' ' << off << ' ' << angle;
      }
    });
  }
}

// The angle is halved, or where the ends are all but opposite the edge is parted where it is nearest to the
// centre, and the distance from the edge stays; and the normal of a short edge has all of its digits.
TEST(Rim, ALineStaysAsFarBesideItsEdgeAsItIsTold) {
  for (const double left : {1e-6, 1e-3, 1.0, 3.0, 3.1415}) {
    const Vec3 from(20.0, 0.0, 0.0);
    const Vec3 to = 31.0 * Vec3(-std::cos(left), std::sin(left), 0.0);
    const RimLine line{from, to, kBesideEdge * across(from, to)};
    const Vec3 middle = line.moved(halves(line.whole())[0].last);
    EXPECT_NEAR(middle.normalized().z() / kBesideEdge, 1.0, 1e-6) << left;
    const double turned = std::atan2(middle.y(), middle.x());
    if (left > 0.8) {
      EXPECT_NEAR(turned, 0.5 * (kPi - left), 1e-9) << left;
    } else {
      EXPECT_NEAR(middle.dot(to - from), 0.0, 1e-9 * middle.norm() * to.norm()) << left;
    }
  }
  const Vec3 end(20.0, 1e-9, 0.0);
  EXPECT_LT(angle_between(across(end, {20.0, 2e-9, 3e-9}), Vec3(0.0, -3.0, 1.0)), 1e-6);
}

}  // namespace
}  // namespace impinge
