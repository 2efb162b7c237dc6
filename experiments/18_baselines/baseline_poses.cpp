// SPDX-License-Identifier: GPL-3.0-or-later
#include "18_baselines/baseline_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "harness/contact_poses.hpp"
#include "methods/cgal.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge::lab {
namespace {

constexpr std::array kOffsets{0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0};  // mm
constexpr std::size_t kTries = 20;  // ways drawn for one that meets the socket

}  // namespace

std::vector<BaselinePose> baseline_poses(const BallSocketPair& joint, const BaselineWays& ways) {
  const auto oracle = make_cgal_tree(joint.ball, joint.socket);
  std::mt19937_64 random(ways.seed);
  std::vector<BaselinePose> poses;
  const std::size_t wanted = ways.count * 2 * kOffsets.size();
  for (std::size_t i = 0; i < kTries * ways.count && poses.size() < wanted; ++i) {
    PosePath path;
    path.axis = uniform_direction(random);
    path.from_turn = path.to_turn = ways.turn * uniform(random);
    path.shift = ways.shift * uniform_direction(random);
    const auto contact = first_contact(path, oracle);
    if (!contact) continue;
    for (const double offset : kOffsets) {
      for (const double beyond : {-offset, offset}) {
        const Pose pose = path.at(*contact + beyond / ways.shift);
        poses.push_back({pose, beyond, oracle(pose)});
      }
    }
  }
  return poses;
}

BaselineVerdicts judge(const Touch& touches, const std::vector<BaselinePose>& poses) {
  BaselineVerdicts verdicts;
  for (const BaselinePose& judged : poses) {
    const bool answer = touches(judged.pose);
    if (answer == judged.touches) continue;
    ++(answer ? verdicts.false_touches : verdicts.missed_touches);
    verdicts.wrong_within_mm = std::max(verdicts.wrong_within_mm, std::abs(judged.beyond_mm));
  }
  return verdicts;
}

}  // namespace impinge::lab
