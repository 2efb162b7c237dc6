// SPDX-License-Identifier: GPL-3.0-or-later
// A way of filling is checked before it is timed: what is right passes, what is wrong by more than its
// tolerance does not.
#include "methods/fill_method.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kAll = 1'000'000;

TEST(FillMethod, AllPassTheirCheck) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  for (const auto& method : {kPairwiseThesis, kRsidThesis, kRsid}) {
    EXPECT_NO_THROW(require_filling(method, pair, Rsid::with_precision(4.0), kAll)) << method.name;
  }
  for (const auto& method : {kUsidThesis, kUsid}) {
    EXPECT_NO_THROW(require_filling(method, pair, Usid::with_precision(4.0), kAll)) << method.name;
  }
}

// The raster of the thesis is no exact one, and a table that lies is found out, however wide its tolerance.
TEST(FillMethod, AWrongOneDoesNotPass) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  FillMethod<Usid> claims_exact = kUsidThesis;
  claims_exact.tolerance = exact_tolerance;
  EXPECT_THROW(require_filling(claims_exact, pair, Usid::with_precision(4.0), kAll), std::runtime_error);
  FillMethod<Usid> wrong = kUsidThesis;
  wrong.fill = [](const TriangleMesh& mesh, const Usid& scheme, Layer layer) {
    auto table = fill_resampled(mesh, scheme, layer);
    table.radii()[table.radii().size() / 4] += 2.0 * resampling_bound(mesh, scheme.precision_deg());
    return table;
  };
  EXPECT_THROW(require_filling(wrong, pair, Usid::with_precision(4.0), kAll), std::runtime_error);
}

// The tables are those of the ball's outer skin and of the socket's inner one.
TEST(FillMethod, FillsBothSurfaces) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  int filled = 0;
  for_both_tables(kUsid, pair, Usid::with_precision(5.0),
                  [&](const auto& table, const TriangleMesh& mesh, Layer layer) {
                    const bool ball = layer == Layer::farthest;
                    EXPECT_EQ(&mesh, ball ? &pair.ball : &pair.socket);
                    EXPECT_NEAR(table.radii()[0], ball ? 22.0 : 26.0, 1.0);
                    ++filled;
                  });
  EXPECT_EQ(filled, 2);
}

}  // namespace
}  // namespace impinge::lab
