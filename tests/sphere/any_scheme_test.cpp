// SPDX-License-Identifier: GPL-3.0-or-later
// A scheme behind one type answers with the very numbers of the scheme itself.
#include "sphere/any_scheme.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sphere/schemes/healpix.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/directions.hpp"

namespace impinge {
namespace {

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
