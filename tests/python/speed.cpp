// SPDX-License-Identifier: GPL-3.0-or-later
// The hip "cam", 10^4 poses, all gaps of both surfaces, as impinge.Joint.gaps() works them out: milliseconds
// of CPU of each round.
#include <cstdio>
#include <ctime>
#include <vector>

#include "gap/simd/exact_cells.hpp"
#include "gap/simd/joint_scan.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/motion.hpp"

int main() {
  using namespace impinge;
  const Hip hip = make_hip(hip_preset("cam"));
  const auto joint = packed_joint(exact_cells(hip.ball, Layer::farthest),
                                  exact_cells(hip.socket, Layer::nearest), hip.ball, hip.socket);
  constexpr std::size_t kPoses = 10'000;
  const std::size_t ball = joint.ball.size();
  const std::size_t socket = joint.socket.size();
  std::vector<float> ball_gap(kPoses * ball);
  std::vector<float> socket_gap(kPoses * socket);
  for (int round = 0; round < 5; ++round) {
    const std::clock_t start = std::clock();
    for (std::size_t k = 0; k < kPoses; ++k) {
      const Motion motion{.flexion = 0.012 * static_cast<double>(k)};
      scan_joint(joint, {joint_rotation(motion, Side::right), Vec3::Zero()},
                 {ball_gap.data() + k * ball, ball}, {socket_gap.data() + k * socket, socket});
    }
    std::printf("%.1f\n", 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
}
