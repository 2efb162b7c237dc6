// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the library keeps no state between calls. Joints read and measured at the same time, each in a
// thread of its own, and scans of one table by several threads give the numbers that one thread gives. Under
// the thread sanitizer this also shows that none of them writes what another reads.
#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "command/joint_options.hpp"
#include "gap/gap_scan.hpp"
#include "joint/document.hpp"
#include "joint/gaps.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/io.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "support/temporary_folder.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

constexpr std::size_t kThreads = 4;

// work(k) for each k at the same time.
template <class Work>
void at_once(const Work& work) {
  std::vector<std::jthread> threads;
  for (std::size_t k = 0; k < kThreads; ++k) threads.emplace_back([&work, k] { work(k); });
}

TEST(Threads, JointsAtTheSameTimeHaveTheSameAnswer) {
  const test::TemporaryFolder folder;
  const BallSocketPair pair = make_ball_socket_pair(200);
  JointOptions options;
  options.ball = folder.path() / "ball.ply";
  options.socket = folder.path() / "socket.stl";
  GapsRequest request;
  request.scheme = "icosahedral_gnomonic";
  request.precision_deg = 5.0;
  write_mesh(options.ball, pair.ball);
  write_mesh(options.socket, pair.socket);
  std::array<Json, kThreads + 1> found;
  const auto run = [&](std::size_t k) {
    Session session = load_joint(options, {});
    found[k] = {json_of(answer(session, request)), json_of(describe(*session.joint, names_of(options)))};
  };
  run(kThreads);
  at_once(run);
  for (std::size_t k = 0; k < kThreads; ++k) EXPECT_EQ(found[k], found[kThreads]) << k;
}

TEST(Threads, OneTableIsScannedByAll) {
  const BallSocketPair pair = make_ball_socket_pair(400);
  const auto table = fill_exact(pair.socket, IcosahedralGnomonic::with_precision(5.0), Layer::nearest);
  std::array<std::vector<double>, kThreads + 1> gap;
  const auto run = [&](std::size_t k) {
    gap[k].resize(pair.ball.vertices.size());
    scan_gaps(table, pair.ball.vertices, {}, Surface::ball, gap[k]);
  };
  run(kThreads);
  at_once(run);
  for (std::size_t k = 0; k < kThreads; ++k) {
    for (std::size_t i = 0; i < gap[k].size(); ++i)
      EXPECT_TRUE(gap[k][i] == gap[kThreads][i] ||
                  (gap[k][i] != gap[k][i] && gap[kThreads][i] != gap[kThreads][i]));
  }
}

}  // namespace
}  // namespace impinge
