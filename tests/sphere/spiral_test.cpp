// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every scheme on a spiral: places are whole at entries, fine tables lose no entry to
// rounding, areas are those between half places, and runs hold the numbers of direction().
#include "sphere/spiral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sphere/schemes/conchoid.hpp"
#include "sphere/schemes/helix_isotropic.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/schemes/usid_arc.hpp"
#include "sphere/walker.hpp"
#include "support/directions.hpp"
#include "support/quadrature.hpp"

namespace impinge {
namespace {

template <class S>
class Spirals : public testing::Test {};
using All = testing::Types<Usid, UsidArc, HelixIsotropic, Conchoid>;
TYPED_TEST_SUITE(Spirals, All);

// Places of entries in all parts of a table, both ends among them.
template <class S>
std::vector<std::size_t> some_entries(const S& scheme) {
  std::vector<std::size_t> entries;
  for (std::size_t k = 0; k <= 60; ++k) {
    entries.push_back(std::min(k, scheme.size() - 1));
    entries.push_back(scheme.size() - 1 - std::min(k, scheme.size() - 1));
    entries.push_back(scheme.size() / 61 * k);
  }
  return entries;
}

// A triangle with a corner at an entry holds it, whatever the rounding of places, turns and directions.
TYPED_TEST(Spirals, FindEntriesAtCornersOfTriangles) {
  const auto u = test::random_directions(200, 80);
  for (const double precision : {5.0, 0.05, 0.001}) {
    const TypeParam scheme = TypeParam::with_precision(precision);
    std::size_t next = 0;
    for (const std::size_t entry : some_entries(scheme)) {
      const Vec3 corner = scheme.direction(entry);
      const TriangleCone cone(corner, (corner + precision * kDegree * u[next]).normalized(),
                              (corner + precision * kDegree * u[next + 1]).normalized());
      next = (next + 1) % 198;
      std::multiset<std::size_t> found;
      for_each_entry_inside(scheme.walker(), cone, [&](std::size_t i, const Vec3& x) {
        found.insert(i);
        ASSERT_EQ(x, scheme.direction(i));
      });
      if (cone.edge_on()) continue;
      ASSERT_EQ(found.count(entry), 1U) << precision << " entry " << entry;
    }
  }
}

// (w - 1) (1 - cos phi_i) / 2 = i of the thesis' helix: the lookup of Section 4.3 without an error.
TYPED_TEST(Spirals, PlacesAreWholeAtEntriesAndBothPolesAreEntries) {
  for (const double precision : {10.0, 1.0, 0.05}) {
    const TypeParam scheme = TypeParam::with_precision(precision);
    EXPECT_EQ(scheme.direction(0), Vec3(0, 0, 1));
    EXPECT_EQ(scheme.direction(scheme.size() - 1), Vec3(0, 0, -1));
    for (std::size_t i = 0; i < scheme.size(); i += 1 + scheme.size() / 5000) {
      ASSERT_NEAR(scheme.place(to_angles(scheme.direction(i)).phi), static_cast<double>(i),
                  1e-14 * static_cast<double>(scheme.size()));
    }
  }
}

TEST(HelixIsotropic, PrecisionIsTheSpacingBothWays) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(1.0);
  EXPECT_EQ(helix.size(), 41253U);  // square degrees on the sphere
  EXPECT_EQ(helix.equator_points(), 360U);
  EXPECT_NEAR(helix.precision_deg(), 1.0, 1e-4);
  const std::size_t equator = helix.size() / 2;
  EXPECT_NEAR(angle_between(helix.direction(equator), helix.direction(equator + 1)), kDegree, 1e-3 * kDegree);
}

TYPED_TEST(Spirals, AFineTableIsLookedUpAtItsEntries) {
  const TypeParam scheme = TypeParam::with_precision(0.05);
  for (const std::size_t entry : some_entries(scheme)) {
    const Stencil stencil = scheme.stencil(scheme.direction(entry));
    double weight = 0.0;
    for (std::size_t k = 0; k < stencil.taps; ++k)
      weight += stencil.entry[k] == entry ? stencil.weight[k] : 0.0;
    EXPECT_NEAR(weight, 1.0, 1e-6) << entry;
  }
}

// Of a band: 2 pi (cos phi(t - 1/2) - cos phi(t + 1/2)), with the place t an entry's number.
TYPED_TEST(Spirals, AreasAreThoseBetweenHalfPlaces) {
  const TypeParam scheme = TypeParam::with_precision(3.0);
  for (const std::size_t entry : some_entries(scheme)) {
    const auto cosine = [&](double t) {
      double low = 0.0;
      double high = kPi;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (scheme.place(middle) < t ? low : high) = middle;
      }
      return std::cos(high);
    };
    const auto i = static_cast<double>(entry);
    const double expected = 2.0 * kPi * (cosine(i - 0.5) - cosine(i + 0.5));
    EXPECT_NEAR(scheme.area(entry), expected, 1e-13) << entry;
  }
}

TYPED_TEST(Spirals, EqualOnesAreEqual) {
  const TypeParam scheme = TypeParam::with_precision(3.0);
  EXPECT_EQ(scheme, TypeParam::with_precision(3.0));
  EXPECT_NE(scheme, TypeParam::with_precision(2.0));
}

// The conchoid spiral: r = a + b cos(phi), equal steps of area, turns at equal distances on the meridian.

constexpr std::array<ConchoidShape, 5> kShapes{{{}, {20.0, 0.0}, {20.0, 1e-7}, {1.0, 0.5}, {1.001, 1.0}}};

double radius(const ConchoidShape& s, double phi) { return s.a + s.b * std::cos(phi); }
double speed(const ConchoidShape& s, double phi) { return std::hypot(radius(s, phi), s.b * std::sin(phi)); }
double area_rate(const ConchoidShape& s, double phi) {
  return 2.0 * kPi * radius(s, phi) * std::sin(phi) * speed(s, phi);
}

// Integral of rate(shape, phi) in pieces that shrink towards both poles.
template <class F>
double from_apex(const F& rate, const ConchoidShape& shape, double phi) {
  const auto f = [&](double x) { return rate(shape, x); };
  double sum = 0.0;
  double from = 0.0;
  for (double rest = kPi; rest > 1e-7; rest *= 0.8) {
    const double to = std::min(phi, kPi - 0.8 * rest);
    if (to <= from) continue;
    sum += test::integral(f, from, to);
    from = to;
  }
  return sum + test::integral(f, from, phi);
}

// Point of the surface in the direction of an entry, mm.
Vec3 point(const Conchoid& spiral, std::size_t entry) {
  const Vec3 u = spiral.direction(entry);
  return (spiral.shape().a + spiral.shape().b * u.z()) * u;
}

TEST(Conchoid, PlacesAndTurnsAreIntegralsOfAreaAndLength) {
  for (const ConchoidShape& shape : kShapes) {
    const ConchoidSteps steps(shape, 10000);
    const double area = from_apex(area_rate, shape, kPi);
    const double h = std::sqrt(area / 10000.0);
    EXPECT_NEAR(steps.spacing() * shape.a, h, 1e-12 * h) << shape.b;
    EXPECT_NEAR(steps.turns(), from_apex(speed, shape, kPi) / h, 1e-11 * steps.turns()) << shape.b;
    for (double phi = 0.01; phi < kPi; phi += 0.05) {
      EXPECT_NEAR(steps.place(phi), steps.last() * from_apex(area_rate, shape, phi) / area, 1e-8) << shape.b;
      EXPECT_NEAR(steps.turn(phi), from_apex(speed, shape, phi) / h, 1e-11 * steps.turns()) << shape.b;
    }
  }
}

// Menschik's acetabulum: 6218.80 mm^2 from the apex to phi = 90 degrees.
TEST(Conchoid, AreaOfTheAcetabulum) {
  const ConchoidShape shape;
  const ConchoidCap cap(Pole::north, shape.b / shape.a);
  EXPECT_NEAR(shape.a * shape.a * cap.whole_area(), 6218.80, 0.005);
}

TEST(Conchoid, InversesHoldUpToBothPoles) {
  for (const ConchoidShape& shape : kShapes) {
    const ConchoidSteps steps(shape, 1'000'001);
    for (double t = 0.25; t <= 1e6; t = t < 5e5 ? 1.3 * t : t + 9973.3) {
      for (const double place : {t, 1e6 - t}) {
        EXPECT_NEAR(steps.place(steps.polar_angle(place)), place, 1e-8) << shape.b;
        const double turn = place / 1e6 * steps.turns();
        EXPECT_NEAR(steps.turn(steps.polar_of_turn(turn)), turn, 1e-11 * steps.turns()) << shape.b;
      }
    }
    EXPECT_EQ(steps.polar_angle(0.0), 0.0);
    EXPECT_EQ(steps.polar_angle(1e6), kPi);
  }
}

// The area of surface between any entry and the next, and the distance on the surface from an entry to the
// next one and to the turn below it, are the same everywhere: A / (N - 1), h and h.
TEST(Conchoid, IsUniformOnTheSurface) {
  for (const ConchoidShape& shape : {ConchoidShape{}, ConchoidShape{1.0, 0.5}}) {
    const Conchoid spiral = Conchoid::with_shape(shape, 40000);
    const double area = from_apex(area_rate, shape, kPi) / 39999.0;
    const auto rate = [&](double phi) { return area_rate(shape, phi); };
    const auto polar = [&](std::size_t i) { return to_angles(spiral.direction(i)).phi; };
    for (std::size_t i = 0; i + 1 < spiral.size(); i += 37) {
      ASSERT_NEAR(test::integral(rate, polar(i), polar(i + 1)), area, 1e-8 * area) << i;
      if (i < 400 || i > 39600) continue;
      ASSERT_NEAR((point(spiral, i) - point(spiral, i + 1)).norm(), spiral.spacing(),
                  0.01 * spiral.spacing());
    }
    const ConchoidSteps steps(shape, 40000);
    for (double turn = 1.0; turn + 2.0 < steps.turns(); turn += 0.37) {
      const auto length = [&](double phi) { return speed(shape, phi); };
      ASSERT_NEAR(test::integral(length, steps.polar_of_turn(turn), steps.polar_of_turn(turn + 1.0)),
                  spiral.spacing(), 1e-9 * spiral.spacing());
    }
  }
}

// By brute force over all entries, in mm: the nearest neighbour is at h, whichever entry it is.
TEST(Conchoid, NearestNeighboursAreOneSpacingAway) {
  const Conchoid spiral = Conchoid::with_shape({}, 4000);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < spiral.size(); ++i) points.push_back(point(spiral, i));
  for (std::size_t i = 120; i + 120 < points.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) nearest = std::min(nearest, (points[i] - points[j]).squaredNorm());
    }
    ASSERT_GT(std::sqrt(nearest), 0.93 * spiral.spacing()) << i;
    ASSERT_LT(std::sqrt(nearest), 1.01 * spiral.spacing()) << i;
  }
}

TEST(Conchoid, IsTheIsotropicHelixOnASphere) {
  const HelixIsotropic helix = HelixIsotropic::with_precision(2.0);
  for (const double b : {0.0, 1e-14, 1e-300}) {
    const Conchoid spiral = Conchoid::with_shape({25.0, b}, helix.size());
    ASSERT_EQ(spiral.size(), helix.size());
    for (std::size_t i = 0; i < helix.size(); ++i)
      ASSERT_LT((spiral.direction(i) - helix.direction(i)).norm(), 1e-12) << b << " entry " << i;
    EXPECT_NEAR(spiral.covering_radius(), helix.covering_radius(), 1e-9);
    EXPECT_NEAR(spiral.precision_deg(), helix.precision_deg(), 1e-9);
  }
}

TEST(Conchoid, PrecisionIsTheSpacingAtTheEquator) {
  for (const double precision : {2.0, 0.1}) {
    const Conchoid spiral = Conchoid::with_precision(precision);
    EXPECT_NEAR(spiral.precision_deg(), precision, 1e-3 * precision);
    EXPECT_EQ(spiral.equator_points(), static_cast<std::size_t>(std::round(360.0 / precision)));
    const auto equator = static_cast<std::size_t>(spiral.place(0.5 * kPi));
    EXPECT_NEAR(angle_between(spiral.direction(equator), spiral.direction(equator + 1)) / kDegree, precision,
                0.01 * precision);
  }
}

// Shapes on the way to a cusp, whose south pole hardly has an entry: nothing is beyond the declared radii.
TEST(Conchoid, RadiiHoldForEveryShape) {
  for (const double b : {0.3, 0.9, 0.99, 0.9999, 1.0 - 1e-9}) {
    for (const std::size_t size : {40U, 300U, 3000U}) {
      const Conchoid spiral = Conchoid::with_shape({1.0, b}, size);
      std::vector<Vec3> entries;
      for (std::size_t i = 0; i < spiral.size(); ++i) entries.push_back(spiral.direction(i));
      double farthest = 0.0;
      for (Vec3 u : test::random_directions(4000, 91)) {
        if (u.x() > 0.5) u.z() -= 3.0;  // more of them about the south pole
        u.normalize();
        double nearest = 4.0;
        for (const Vec3& e : entries) nearest = std::min(nearest, (u - e).squaredNorm());
        farthest = std::max(farthest, 2.0 * std::asin(0.5 * std::sqrt(nearest)));
        const Stencil stencil = spiral.stencil(u);
        for (std::size_t k = 0; k < stencil.taps; ++k)
          ASSERT_LE(angle_between(u, entries[stencil.entry[k]]), spiral.stencil_radius()) << b << ' ' << size;
      }
      EXPECT_LE(farthest, spiral.covering_radius()) << b << ' ' << size;
      EXPECT_GE(farthest, 0.25 * spiral.covering_radius()) << b << ' ' << size;
    }
  }
}

TEST(Conchoid, RefusesShapesThatAreNone) {
  const double nan = std::nan("");
  for (const ConchoidShape& shape : {ConchoidShape{1.0, 1.0},
                                     {1.0, 2.0},
                                     {0.0, 0.0},
                                     {-1.0, 0.5},
                                     {1.0, -0.5},
                                     {nan, 0.5},
                                     {1.0, nan},
                                     {HUGE_VAL, 1.0},
                                     {HUGE_VAL, HUGE_VAL}}) {
    EXPECT_THROW(Conchoid::with_shape(shape, 1000), std::invalid_argument) << shape.a << ' ' << shape.b;
  }
  EXPECT_NO_THROW(Conchoid::with_shape({1.0, std::nextafter(1.0, 0.0)}, 1000));
}

TEST(Conchoid, RefusesTooFewAndTooManyEntries) {
  for (const std::size_t entries :
       {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{10'000'000'000'000}}) {
    EXPECT_THROW(Conchoid::with_shape({}, entries), std::invalid_argument) << entries;
  }
  EXPECT_EQ(Conchoid::with_shape({}, 10'000'000'000).size(), 10'000'000'000U);
}

}  // namespace
}  // namespace impinge
