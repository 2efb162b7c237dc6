// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "18_baselines/baseline_study.hpp"
#include "harness/contact_poses.hpp"
#include "methods/cgal.hpp"
#include "reference/closest_point.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge::lab {
namespace {

// At most `most` of the points, evenly chosen.
std::vector<Vec3> some_of(const std::vector<Vec3>& points, std::size_t most) {
  std::vector<Vec3> some;
  const std::size_t stride = points.size() / most + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  return some;
}

constexpr std::array kOffsets{0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0};  // mm
constexpr std::size_t kTries = 20;  // paths drawn for one that meets the socket

}  // namespace

BaselineAnswers judge_answers(const std::vector<double>& answers, const std::vector<double>& exact) {
  BaselineAnswers summary;
  summary.points = exact.size();
  double squares = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (std::isnan(answers[i])) {
      ++summary.missed;
      continue;
    }
    const double error = std::abs(answers[i] - exact[i]);
    largest = std::max(largest, error);
    squares += error * error;
  }
  if (summary.missed == summary.points) return summary;
  summary.largest_mm = largest;
  summary.rms_mm = std::sqrt(squares / static_cast<double>(summary.points - summary.missed));
  return summary;
}

BaselinePoints baseline_points(const BallSocketPair& joint, std::size_t most) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.3, Vec3(0.3, -1.0, 0.2).normalized()).toRotationMatrix();
  BaselinePoints points;
  for (const Vec3& x : some_of(joint.ball.vertices, most)) points.on_ball.push_back(to_socket(pose, x));
  points.distance = closest_distances(joint.socket, {points.on_ball});
  std::vector<Vec3> all;
  for (const Vec3& y : some_of(joint.socket.vertices, most)) all.push_back(to_ball(pose, y));
  const std::vector<double> radius = exact_radii(joint.ball, {all, Layer::farthest});
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::isnan(radius[i])) continue;
    points.on_socket.push_back(all[i]);
    points.radius.push_back(radius[i]);
  }
  return points;
}

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
