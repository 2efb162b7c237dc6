// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/algorithm_2.hpp"

// Concentric spheres of radii B and S. A ball vertex has d_i = B and reads d = S, a socket vertex has d_i = S
// and reads d = B: the comparison d <= d_i says S <= B of the first and B <= S of the second.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "mesh/bodies.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

struct Both {
  ScanVerdicts ball;
  ScanVerdicts socket;
};

Both compare(double ball_radius, double socket_radius) {
  const Rsid scheme = Rsid::with_precision(2.0);
  const TriangleMesh ball = sphere(ball_radius, 500);
  const TriangleMesh socket = sphere(socket_radius, 500);
  std::vector<double> gap(ball.vertices.size());
  scan_gaps(fill_exact(socket, scheme, Layer::nearest), ball.vertices, {}, Surface::ball, gap);
  const ScanVerdicts of_ball = compare_as_written(gap, Surface::ball);
  gap.resize(socket.vertices.size());
  scan_gaps(fill_exact(ball, scheme, Layer::farthest), socket.vertices, {}, Surface::socket, gap);
  return {of_ball, compare_as_written(gap, Surface::socket)};
}

TEST(Algorithm2, CallsEverySocketVertexOfAClearPoseImpinged) {
  const Both clear = compare(22.0, 26.0);
  EXPECT_GT(clear.ball.met, 0U);
  EXPECT_EQ(clear.ball.by_gap, 0U);
  EXPECT_EQ(clear.ball.as_written, 0U);
  EXPECT_GT(clear.socket.met, 0U);
  EXPECT_EQ(clear.socket.by_gap, 0U);
  EXPECT_EQ(clear.socket.as_written, clear.socket.met);
}

TEST(Algorithm2, CallsNoSocketVertexOfAPenetratingPoseImpinged) {
  const Both penetrating = compare(27.0, 26.0);
  EXPECT_EQ(penetrating.ball.by_gap, penetrating.ball.met);
  EXPECT_EQ(penetrating.ball.as_written, penetrating.ball.met);
  EXPECT_EQ(penetrating.socket.by_gap, penetrating.socket.met);
  EXPECT_EQ(penetrating.socket.as_written, 0U);
}

TEST(Algorithm2, CountsContactInBothAndNoSurfaceInNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> gap{0.0, none, 1.0, -1.0, none};
  for (const Surface scanned : {Surface::ball, Surface::socket}) {
    const ScanVerdicts verdicts = compare_as_written(gap, scanned);
    EXPECT_EQ(verdicts.met, 3U);
    EXPECT_EQ(verdicts.by_gap, 2U);
    EXPECT_EQ(verdicts.as_written, 2U);
  }
}

}  // namespace
}  // namespace impinge::lab
