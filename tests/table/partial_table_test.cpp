// SPDX-License-Identifier: GPL-3.0-or-later
// A table of the entries that are read answers as the table of all of them, bit for bit:
//   partial.radius_at(x) == full.radius_at(x) for every x whose taps were inserted
#include "table/partial_table.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/latitude_rows.hpp"
#include "sphere/schemes/rsid.hpp"
#include "support/directions.hpp"
#include "support/soup.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

constexpr double kPrecision = 3.0;  // degrees

PartialTable partial_of(const TriangleMesh& mesh, const AnyScheme& scheme, const std::vector<Vec3>& asked,
                        Layer layer) {
  EntrySet entries(scheme.size());
  for (const Vec3& x : asked) insert_taps(scheme, x, entries);
  entries.number();
  const NearFaces faces(mesh, scheme.stencil_radius());
  return fill_partial(faces, scheme, std::move(entries), layer);
}

template <class S>
class PartialTableOf : public ::testing::Test {
 protected:
  // Returns how many answers a rim has taken.
  static std::size_t expect_same(const TriangleMesh& mesh, const std::vector<Vec3>& asked, Layer layer) {
    const S scheme = S::with_precision(kPrecision);
    const RadialTable<S> full = fill_exact(mesh, scheme, layer);
    const PartialTable partial = partial_of(mesh, AnyScheme(S::name, kPrecision), asked, layer);
    std::size_t at_a_rim = 0;
    for (const Vec3& x : asked) {
      const double expected = full.radius_at(x);
      const double found = partial.radius_at(x);
      EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected)))
          << x.transpose() << ": " << found << " against " << expected;
      at_a_rim += full.is_rim_cell(scheme.stencil(x).cell) ? 1U : 0U;
    }
    EXPECT_LT(partial.kept().count(), scheme.size());
    return at_a_rim;
  }
};
using Schemes = ::testing::Types<Rsid, IcosahedralGnomonic, LatitudeRows>;
TYPED_TEST_SUITE(PartialTableOf, Schemes);

TYPED_TEST(PartialTableOf, AnswersAsTheFullTableOfASocket) {
  const TriangleMesh socket = make_ball_socket_pair(800).socket;
  std::vector<Vec3> asked = test::random_directions(150, 7);
  for (std::size_t v = 0; v < socket.vertices.size(); v += 3) asked.push_back(socket.vertices[v]);
  EXPECT_GT(this->expect_same(socket, asked, Layer::nearest), 0U) << "the rim is met";
}

TYPED_TEST(PartialTableOf, AnswersAsTheFullTableOfAClosedBall) {
  EXPECT_EQ(
      this->expect_same(make_ball_socket_pair(800).ball, test::random_directions(150, 8), Layer::farthest),
      0U);
}

// Folds, jumps and steep faces all over the place.
TYPED_TEST(PartialTableOf, AnswersAsTheFullTableOfFacesAtRandom) {
  EXPECT_GT(this->expect_same(test::soup(60, 9), test::random_directions(200, 10), Layer::nearest), 0U);
}

TEST(PartialTable, WhatIsNotKeptHasNoAnswer) {
  const TriangleMesh ball = make_ball_socket_pair(800).ball;
  const AnyScheme scheme("rsid", kPrecision);
  const PartialTable partial = partial_of(ball, scheme, {Vec3(0.3, 0.4, 0.8)}, Layer::farthest);
  EXPECT_EQ(partial.kept().count(), 4U);
  EXPECT_FALSE(std::isnan(partial.radius_at({0.3, 0.4, 0.8})));
  EXPECT_TRUE(std::isnan(partial.radius_at({-0.3, 0.4, 0.8})));
}

}  // namespace
}  // namespace impinge
