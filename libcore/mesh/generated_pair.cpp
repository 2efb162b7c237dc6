// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generated_pair.hpp"

#include <cmath>
#include <stdexcept>

#include "mesh/bodies.hpp"

namespace impinge {

PairShape impinging_cam() {
  PairShape shape;
  shape.cam_height = 5.0;
  return shape;
}

Vec3 cam_direction(const PairShape& shape) {
  return to_direction({shape.cam_polar_deg * kDegree, shape.cam_azimuth_deg * kDegree});
}

double ball_radius(const Vec3& direction, const PairShape& shape) {
  const double t = angle_between(direction, cam_direction(shape)) / (shape.cam_half_width_deg * kDegree);
  if (t >= 1.0) return shape.head_radius;
  const double c = std::cos(0.5 * kPi * t);
  return shape.head_radius + shape.cam_height * c * c;
}

BallSocketPair make_ball_socket_pair(std::size_t faces_per_model, const PairShape& shape) {
  if (!(shape.head_radius > 0.0 && shape.cam_height >= 0.0 && shape.cam_half_width_deg > 0.0)) {
    throw std::invalid_argument(
        "a ball needs a positive head radius and cam width, and no negative cam height");
  }
  return {radial_body(faces_per_model, [&shape](const Vec3& u) { return ball_radius(u, shape); }),
          cup(shape.socket_radius, shape.half_opening_deg, faces_per_model)};
}

}  // namespace impinge
