// SPDX-License-Identifier: GPL-3.0-or-later
#include "18_baselines/baseline_points.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "reference/closest_point.hpp"
#include "reference/exact_radius.hpp"

namespace impinge::lab {

namespace {

// At most `most` of the points, evenly chosen.
std::vector<Vec3> some_of(const std::vector<Vec3>& points, std::size_t most) {
  std::vector<Vec3> some;
  const std::size_t stride = points.size() / most + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  return some;
}

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

}  // namespace impinge::lab
