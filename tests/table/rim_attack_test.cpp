// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: near an edge that is all but tangent to the border of a cell a table of any scheme answers none,
// or within the bound that DirectionBounds has for it:
//   |table.radius_at(x) - radius of the mesh along x| <= at(x)
// A triangle close to the centre stands before an octahedron far behind it. One of its edges touches the
// border of two cells from either side and pokes into the other cell, wide or narrow, by as little as 1e-9
// radians, between two steps of whoever follows it. The truth is Cramer's rule in long double, face by face.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "sphere/scheme_list.hpp"
#include "support/dice.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/random_cases.hpp"
#include "support/wrapped_scheme.hpp"
#include "table/direction_bounds.hpp"

namespace impinge {
namespace {

using test::Dice;
using LongVec3 = Eigen::Matrix<long double, 3, 1>;

// Radius of the nearest face along u, NaN where there is none; nothing beside an edge, where it is uncertain.
std::optional<double> true_radius(const TriangleMesh& mesh, const Vec3& u) {
  constexpr long double kDoubt = 1e-15L;
  double nearest = std::nan("");
  const LongVec3 ray = u.cast<long double>();
  for (const Face& face : mesh.faces) {
    std::array<LongVec3, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = corner(mesh, face, k).cast<long double>();
    const long double volume = v[0].dot(v[1].cross(v[2]));
    const long double side = volume < 0.0L ? -1.0L : 1.0L;
    long double sum = 0.0L;
    long double least = 1.0L;
    for (std::size_t k = 0; k < 3; ++k) {
      const LongVec3& a = v[k];
      const LongVec3& b = v[(k + 1) % 3];
      const long double share = side * ray.dot(a.cross(b));
      least = std::min(least, share / (a.norm() * b.norm()));
      sum += share;
    }
    if (least < -kDoubt) continue;
    if (least < kDoubt) return std::nullopt;
    const auto radius = static_cast<double>(side * volume / sum);
    if (!(radius > nearest)) nearest = radius;
  }
  return nearest;
}

// Where the cell changes on the arc between two directions of different cells.
template <class S>
Vec3 border_between(const S& scheme, Vec3 from, Vec3 to) {
  const std::size_t cell = scheme.stencil(from).cell;
  for (int step = 0; step < 48; ++step) {
    const Vec3 middle = (from + to).normalized();
    (scheme.stencil(middle).cell == cell ? from : to) = middle;
  }
  return to;
}

// A place on a border, unit, and the unit direction of the border there.
struct Tangent {
  Vec3 place;
  Vec3 along;
};

template <class S>
Tangent random_tangent(const S& scheme, Dice& dice) {
  const double near = 1e-5;
  while (true) {
    const Vec3 inside = dice.direction();
    const Vec3 outside = (inside + 1.5 * scheme.covering_radius() * dice.direction()).normalized();
    if (scheme.stencil(inside).cell == scheme.stencil(outside).cell) continue;
    const Vec3 place = border_between(scheme, inside, outside);
    const Vec3 way = (outside - inside).normalized();
    const Vec3 beside = near * place.cross(way).normalized();
    const Vec3 before = (place + beside - 3.0 * near * way).normalized();
    const Vec3 beyond = (place + beside + 3.0 * near * way).normalized();
    if (scheme.stencil(before).cell == scheme.stencil(beyond).cell) continue;
    const Vec3 along = border_between(scheme, before, beyond) - place;
    return {place, (along - along.dot(place) * place).normalized()};
  }
}

// An edge beside the border of two cells.
struct TangentialEdge {
  Vec3 middle;   // of the part that is close to the border, unit
  Vec3 along;    // unit
  Vec3 across;   // unit, towards the triangle
  double aside;  // radians
};

TangentialEdge random_edge(const Tangent& tangent, Dice& dice) {
  const double aside = std::pow(10.0, dice.between(-9.0, -2.5));
  const Vec3 across = dice.sign() * tangent.place.cross(tangent.along);
  const Vec3 middle = (tangent.place + dice.sign() * aside * across).normalized();
  return {middle, tangent.along, middle.cross(tangent.along.cross(middle)).cross(tangent.along).normalized(),
          aside};
}

// The edge reaches up to `widest` degrees to either side of its middle.
TriangleMesh before_octahedron(const TangentialEdge& edge, double widest, Dice& dice) {
  constexpr double kNear = 10.0;
  const auto reach = [&](double least, double most) {
    return kNear * std::tan(dice.between(least, most) * kDegree);
  };
  const bool wide = dice.sign() > 0.0;
  TriangleMesh mesh = octahedron(1000.0);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), dice.direction());
  for (Vec3& v : mesh.vertices) v = turn * v;
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  const Vec3 foot = kNear * edge.middle;
  mesh.vertices.push_back(foot - reach(wide ? 60.0 : 0.5, wide ? widest : 20.0) * edge.along);
  mesh.vertices.push_back(foot + reach(wide ? 60.0 : 0.5, wide ? widest : 20.0) * edge.along);
  mesh.vertices.push_back(foot + reach(20.0, 75.0) * edge.across);
  mesh.faces.push_back({first, first + 1, first + 2});
  return mesh;
}

// A surface, its table, and where to look beside an edge.
template <class S>
struct RimScene {
  TangentialEdge edge;
  TriangleMesh mesh;
  RadialTable<S> table;

  // Calls visit(x, radius, truth) along so many directions, so far to both sides of the edge, that have both.
  template <class Visit>
  void for_each_answer(double along, double across, Dice& dice, Visit&& visit) const {
    for (int k = 0; k < 16; ++k) {
      const Vec3 x = (edge.middle + along * dice.between(-1.5, 1.5) * edge.along +
                      across * dice.between(-1.2, 1.2) * edge.across)
                         .normalized();
      const double radius = table.radius_at(x);
      if (std::isnan(radius)) continue;
      if (const auto truth = true_radius(mesh, x)) visit(x, radius, *truth);
    }
  }
};

template <class S>
RimScene<S> random_scene(const S& scheme, double widest, Dice& dice) {
  const TangentialEdge edge = random_edge(random_tangent(scheme, dice), dice);
  const TriangleMesh mesh = before_octahedron(edge, widest, dice);
  return {edge, mesh, fill_exact(mesh, scheme, Layer::nearest)};
}

// Looks for an answer of a wrong layer in the slivers between edge and border, as long and as high as they
// are for borders of any bend. Says how many answers there were.
template <class S>
std::size_t attack(const S& scheme, Dice& dice) {
  constexpr double kMixed = 50.0;  // mm, above what an octahedron costs almost everywhere
  const RimScene<S> scene = random_scene(scheme, 89.0, dice);
  std::optional<DirectionBounds<S>> bounds;
  std::size_t answers = 0;
  const double aside = scene.edge.aside;
  scene.for_each_answer(std::sqrt(aside), aside, dice, [&](const Vec3& x, double radius, double truth) {
    ++answers;
    const double error = std::abs(radius - truth);
    if (error < kMixed) return;
    if (!bounds) bounds.emplace(scene.mesh, scene.table, Layer::nearest, BoundOptions{.budget = 0});
    EXPECT_LE(error, bounds->at(x)) << S::name << " along " << x.transpose() << ", " << aside << " aside";
  });
  return answers;
}

// Every second scheme, so that two cores share them: a case takes a millisecond.
class TheoremRimAttack : public testing::TestWithParam<std::size_t> {};

INSTANTIATE_TEST_SUITE_P(Schemes, TheoremRimAttack, testing::Values(0, 1),
                         [](const auto& of) { return of.param == 0 ? "Even" : "Odd"; });

TEST_P(TheoremRimAttack, NoTangentialEdgePokesIntoACellThatAnswers) {
  std::size_t schemes = 0;
  bool borders_known = false;  // of any; a scheme that tells none answers nowhere near an edge
  test::every_scheme([&]<class S>() {
    ++schemes;
    borders_known |= HasKnownBorders<S>;
  });
  std::size_t number = 0;
  std::size_t answers = 0;
  test::every_scheme([&]<class S>() {
    if (schemes > 1 && number++ % 2 != GetParam()) return;
    Dice dice(18);
    const S scheme = S::with_precision(10.0);
    for (std::size_t k = 0; k < random_cases() / schemes + 1 && !HasFailure(); ++k)
      answers += attack(scheme, dice);
  });
  if (schemes > 1 || borders_known) {
    EXPECT_GT(answers, schemes);
  }
}

// A scheme that says nothing about the borders of its cells.
template <class S>
class Silent : public test::Wrapped<S> {
 public:
  static Silent with_precision(double degrees) {
    Silent scheme;
    scheme.hold(S::with_precision(degrees));
    return scheme;
  }
};

// No bound tells mixed layers there; but no answer is far from a layer that is a hundred times as near or
// far.
template <class S>
void attack_silent(std::size_t cases) {
  constexpr double kAlike = 8.0;
  static_assert(SamplingScheme<Silent<S>> && !HasKnownBorders<Silent<S>>);
  Dice dice(18);
  const auto scheme = Silent<S>::with_precision(10.0);
  const double reach = scheme.stencil_radius();
  std::size_t answers = 0;
  for (std::size_t k = 0; k < cases && !testing::Test::HasFailure(); ++k) {
    const auto scene = random_scene(scheme, 75.0, dice);
    const auto expect_one_layer = [&](const Vec3& x, double radius, double truth) {
      ++answers;
      EXPECT_LT(std::max(radius / truth, truth / radius), kAlike) << S::name << " along " << x.transpose();
    };
    scene.for_each_answer(std::sqrt(scene.edge.aside), scene.edge.aside, dice, expect_one_layer);
    scene.for_each_answer(3.0 * reach, 3.0 * reach, dice, expect_one_layer);
  }
  EXPECT_GT(answers, cases) << S::name;
}

TEST(TheoremRimUntold, NorIntoOneOfASchemeThatSaysNothingAboutBorders) {
  attack_silent<Rsid>(random_cases() / 2);
  attack_silent<LatitudeRows>(random_cases() / 2);
}

// The least and the largest distance from the centre, held against a thousand points of the stretch.
TEST(Rim, AStretchIsSeenWhereItIsMostLikelyTo) {
  const auto ends = test::random_directions(200, 35);
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    const Vec3 first = 20.0 * ends[k];
    const Vec3 last = 30.0 * ends[k + 1];
    double least = 30.0;
    double largest = 20.0;
    for (int i = 0; i <= 1000; ++i) {
      const double length = (first + 1e-3 * i * (last - first)).norm();
      least = std::min(least, length);
      largest = std::max(largest, length);
    }
    EXPECT_NEAR(radius_to_be_seen(first, last, Layer::nearest), least, 0.01);
    EXPECT_LE(radius_to_be_seen(first, last, Layer::nearest), least + 1e-12);
    EXPECT_NEAR(radius_to_be_seen(first, last, Layer::farthest), largest, 1e-12);
  }
}

}  // namespace
}  // namespace impinge
