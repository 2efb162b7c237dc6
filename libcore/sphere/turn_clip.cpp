// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/turn_clip.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace impinge {
namespace {

// The number of pieces, so narrow that a parallel leaves its chord by at most a spacing of the turns.
std::size_t piece_count(double width, double spacing, std::size_t most) {
  const double widest = std::sqrt(8.0 * spacing);
  return std::min(static_cast<std::size_t>(width / widest) + 1, most);
}

}  // namespace

TurnClip::TurnClip(const TriangleCone& cone, const AngularBox& box, const Accuracy& accuracy)
    : pieces_(piece_count(box.theta_width, accuracy.spacing, kMostPieces)),
      azimuth_(box.theta_min / (2.0 * kPi)),
      width_(box.theta_width / (2.0 * kPi) / static_cast<double>(pieces_)),
      bend_(0.5 * kPi * kPi * width_ * width_) {
  const double leeway = (accuracy.margin < 0.5 * kPi ? std::sin(accuracy.margin) : 2.0) + accuracy.doubt;
  std::array<Vec3, 3> plane;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = cone.corners()[k];
    const Vec3& to = cone.corners()[(k + 1) % 3];
    plane[k] = cone.side() * from.cross(to);
    length_[k] = plane[k].norm();
    // The second term is the rounding of the plane: a plane that is nothing but rounding clips nothing.
    leeway_[k] = leeway * length_[k] + 2.0 * cone.doubt();
    upright_[k] = plane[k].z();
  }
  for (std::size_t border = 0; border <= pieces_; ++border) {
    const double theta = 2.0 * kPi * azimuth(border);
    const double x = std::cos(theta);
    const double y = std::sin(theta);
    for (std::size_t k = 0; k < 3; ++k) level_[border][k] = plane[k].x() * x + plane[k].y() * y;
  }
}

}  // namespace impinge
