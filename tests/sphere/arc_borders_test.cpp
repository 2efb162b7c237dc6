// SPDX-License-Identifier: GPL-3.0-or-later
// Contract of meets_cells_once(), for every scheme that tells the borders of its cells: where it says so,
// dense samples of the arc are in each cell in one stretch; and it says so of almost every short arc.
#include "sphere/arc_borders.hpp"

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sphere/any_scheme.hpp"
#include "sphere/schemes/healpix.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/directions.hpp"
#include "support/every_scheme.hpp"
#include "support/random_cases.hpp"
#include "support/random_vector.hpp"

namespace impinge {
namespace {

struct Arc {
  Vec3 from;  // unit
  Vec3 to;    // unit
};

// From a direction at most `longest` radians on; a third of them close to a pole.
Arc random_arc(std::mt19937_64& random, double longest) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const Vec3 way = test::random_vector(normal, random);
  Vec3 from = way.normalized();
  if (share(random) < 0.3)
    from = (Vec3(0, 0, share(random) < 0.5 ? -1 : 1) + 0.2 * share(random) * from).normalized();
  const Vec3 aside = from.cross(test::random_vector(normal, random)).normalized();
  const double length = longest * share(random);
  return {from, std::cos(length) * from + std::sin(length) * aside};
}

// Does a cell come back after it was left, in so many samples?
template <class S>
bool comes_back(const S& scheme, const Arc& arc, int samples) {
  std::set<std::size_t> left;
  std::size_t here = scheme.stencil(arc.from).cell;
  for (int k = 1; k <= samples; ++k) {
    const double t = static_cast<double>(k) / samples;
    const std::size_t cell = scheme.stencil((1.0 - t) * arc.from + t * arc.to).cell;
    if (cell == here) continue;
    left.insert(here);
    if (left.contains(cell)) return true;
    here = cell;
  }
  return false;
}

TEST(TheoremRim, AnArcThatIsSaidToMeetCellsOnceDoes) {
  constexpr std::size_t kSchemes = 13;
  test::every_scheme([]<class S>() {
    if constexpr (HasKnownBorders<S>) {
      const S scheme = S::with_precision(9.0);
      std::mt19937_64 random(5);
      std::size_t said = 0;
      for (std::size_t k = 0; k < random_cases() / kSchemes + 1; ++k) {
        const Arc arc = random_arc(random, k % 2 == 0 ? 0.3 : 2.0);
        if (!meets_cells_once(scheme, arc.from, arc.to)) continue;
        ++said;
        ASSERT_FALSE(comes_back(scheme, arc, 150))
            << S::name << " from " << arc.from.transpose() << " to " << arc.to.transpose();
      }
      EXPECT_GT(said, 0U) << S::name;
    }
  });
}

// Else following a rim would take for ever.
TEST(ArcBorders, AlmostEveryShortArcIsSaidToMeetCellsOnce) {
  test::every_scheme([]<class S>() {
    if constexpr (HasKnownBorders<S>) {
      const S scheme = S::with_precision(2.0);
      std::mt19937_64 random(6);
      int said = 0;
      for (int k = 0; k < 1000; ++k) {
        const Arc arc = random_arc(random, 0.05 * scheme.covering_radius());
        said += meets_cells_once(scheme, arc.from, arc.to) ? 1 : 0;
      }
      EXPECT_GT(said, 950) << S::name;
    }
  });
}

TEST(ArcBorders, OfAnySchemeAreThoseOfTheScheme) {
  test::every_scheme([]<class S>() {
    const S scheme = S::with_precision(9.0);
    const AnyScheme any(S::name, 9.0);
    ASSERT_EQ(any.has_known_borders(), HasKnownBorders<S>) << S::name;
    if constexpr (HasKnownBorders<S>) {
      std::mt19937_64 random(7);
      for (int k = 0; k < 100; ++k) {
        const Arc arc = random_arc(random, 0.5);
        EXPECT_EQ(meets_cells_once(any, arc.from, arc.to), meets_cells_once(scheme, arc.from, arc.to))
            << S::name;
      }
    }
  });
}

// f(t) = a + 4 h t (1 - t) bends by 8 h and touches a + h: the bound of the dip is reached.
TEST(ArcBorders, TheBoundOfADipIsSharp) {
  const double h = 0.25;
  EXPECT_TRUE(passes_lines_once(0.74, 0.74, 8.0 * h));
  EXPECT_FALSE(passes_lines_once(0.76, 0.76, 8.0 * h));
  EXPECT_FALSE(passes_lines_once(0.24, 0.24, 8.0 * h));
  // f(t) = t^2 / 2 rises by half of its bend, and begins level.
  EXPECT_TRUE(passes_lines_once(0.9, 1.9, 1.99));
  EXPECT_FALSE(passes_lines_once(0.9, 1.9, 2.01));
}

// The highest point of a circle is inside or it is not; an arc of more than a quarter turn is not told.
TEST(ArcBorders, LatitudeIsMonotoneUpToTheHighestPoint) {
  const auto at = [](double degrees) -> Vec3 {  // on the circle that rises 40 degrees
    const double s = degrees * kDegree;
    return std::cos(s) * Vec3(std::cos(40 * kDegree), 0, std::sin(40 * kDegree)) +
           std::sin(s) * Vec3(0, 1, 0);
  };
  for (const double turn : {0.0, 180.0}) {
    EXPECT_TRUE(latitude_is_monotone(at(turn + 1e-6), at(turn + 60)));
    EXPECT_TRUE(latitude_is_monotone(7.0 * at(turn - 60), 1e-3 * at(turn - 1e-6)));
    EXPECT_FALSE(latitude_is_monotone(at(turn - 1e-6), at(turn + 60)));
    EXPECT_FALSE(latitude_is_monotone(at(turn + 60), at(turn - 1e-6)));
  }
  EXPECT_FALSE(latitude_is_monotone(at(1), at(178)));
}

// A scheme behind one type answers with the very numbers of the scheme itself.

void expect_same(const Stencil& a, const Stencil& b) {
  EXPECT_EQ(a.entry, b.entry);
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_EQ(a.taps, b.taps);
  EXPECT_EQ(a.cell, b.cell);
}

template <class S>
class AnySchemeOf : public ::testing::Test {};
using Schemes = ::testing::Types<Rsid, IcosahedralGnomonic, Healpix>;
TYPED_TEST_SUITE(AnySchemeOf, Schemes);

TYPED_TEST(AnySchemeOf, HasItsNumbers) {
  const auto scheme = TypeParam::with_precision(5.0);
  const AnyScheme any(TypeParam::name, 5.0);
  EXPECT_EQ(any.name(), TypeParam::name);
  EXPECT_EQ(any.size(), scheme.size());
  EXPECT_EQ(any.cells(), scheme.cells());
  EXPECT_EQ(any.precision_deg(), scheme.precision_deg());
  EXPECT_EQ(any.covering_radius(), scheme.covering_radius());
  EXPECT_EQ(any.stencil_radius(), scheme.stencil_radius());
  for (std::size_t i = 0; i < scheme.size(); i += 7) EXPECT_EQ(any.direction(i), scheme.direction(i));
  for (const Vec3& u : test::random_directions(200, 1)) expect_same(any.stencil(u), scheme.stencil(u));
}

TYPED_TEST(AnySchemeOf, WalksAndCrossesCellsAsItDoes) {
  const auto scheme = TypeParam::with_precision(5.0);
  const AnyScheme any(TypeParam::name, 5.0);
  const TriangleCone cone({1, 0.1, 0.2}, {0.1, 1, 0.3}, {0.2, 0.1, 1});
  std::vector<std::size_t> ours;
  std::vector<std::size_t> theirs;
  any.walker().visit_near(cone, 0.1, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) ours.push_back(run.first + k);
  });
  scheme.walker().visit_near(cone, 0.1, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) theirs.push_back(run.first + k);
  });
  EXPECT_EQ(ours, theirs);
  EXPECT_FALSE(ours.empty());
  ours.clear();
  theirs.clear();
  const Stencil at = scheme.stencil({0.3, 0.2, 0.9});
  any.for_each_cell_across(at, [&](const Stencil& other) { ours.push_back(other.cell); });
  if constexpr (requires { scheme.for_each_cell_across(at, AnyScheme::VisitStencil()); })
    scheme.for_each_cell_across(at, [&](const Stencil& other) { theirs.push_back(other.cell); });
  EXPECT_EQ(ours, theirs);
}

TEST(AnyScheme, RefusesANameOrAPrecisionThatThereIsNot) {
  EXPECT_THROW(AnyScheme("rsidd", 1.0), std::invalid_argument);
  EXPECT_THROW(AnyScheme("rsid", 0.7), std::invalid_argument);
  for (const std::string& name : all_scheme_names()) EXPECT_EQ(AnyScheme(name, 15.0).name(), name);
}

}  // namespace
}  // namespace impinge
