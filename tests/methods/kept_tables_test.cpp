// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that are kept and filled again hold what tables made for the purpose hold, bit for bit.
#include "methods/kept_tables.hpp"

#include <cmath>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

constexpr double kPrecision = 2.0;  // degrees

void expect_same_bits(std::span<const double> found, std::span<const double> expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_TRUE(found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i]))) << i;
}

TEST(KeptTables, HoldWhatNewTablesHoldHoweverOftenTheyAreFilled) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  const auto ball = fill_thesis(pair.ball, Rsid::with_precision(kPrecision), Layer::farthest);
  const auto socket = fill_thesis(pair.socket, Rsid::with_precision(kPrecision), Layer::nearest);
  KeptTables kept(pair, kPrecision);
  for (int times = 0; times < 3; ++times) {
    kept.fill_grids();
    expect_same_bits(kept.ball_grid().radii(), ball.radii());
    expect_same_bits(kept.socket_grid().radii(), socket.radii());
  }
}

TEST(KeptTables, HelicesAreReadFromTheGrids) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  KeptTables kept(pair, kPrecision);
  EXPECT_TRUE(std::isnan(kept.ball_helix().radii()[0]));
  kept.fill_helices();
  const auto ball = resample(kept.ball_grid(), kept.ball_helix().scheme());
  const auto socket = resample(kept.socket_grid(), kept.socket_helix().scheme());
  expect_same_bits(kept.ball_helix().radii(), ball.radii());
  expect_same_bits(kept.socket_helix().radii(), socket.radii());
  EXPECT_NEAR(kept.ball_helix().radii()[0], 22.0, 1.0);
}

// Another joint's tables are found out.
TEST(KeptTables, AreCheckedBeforeTheyAreTimed) {
  const BallSocketPair pair = make_ball_socket_pair(300);
  KeptTables kept(pair, kPrecision);
  EXPECT_NO_THROW(require_kept(kept, pair, 100'000));
  BallSocketPair larger = pair;
  for (Vec3& v : larger.ball.vertices) v *= 1.5;
  EXPECT_THROW(require_kept(kept, larger, 100'000), std::runtime_error);
}

}  // namespace
}  // namespace impinge::lab
