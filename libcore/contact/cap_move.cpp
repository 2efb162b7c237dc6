// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/cap_move.hpp"

namespace impinge {

CapMove::CapMove(Surface surface, const Pose& at)
    : scanned(surface), pose(at), shift(static_cast<float>(at.translation.norm())) {
  const Vec3 in_ball_frame = at.rotation.transpose() * at.translation;
  const bool ball = scanned == Surface::ball;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto row = static_cast<std::size_t>(k);
    for (Eigen::Index l = 0; l < 3; ++l)
      rotation[row][static_cast<std::size_t>(l)] =
          static_cast<float>(ball ? at.rotation(k, l) : at.rotation(l, k));
    translation[row] = static_cast<float>(ball ? at.translation[k] : -in_ball_frame[k]);
    own[row] = static_cast<float>(ball ? in_ball_frame[k] : -at.translation[k]);
  }
}

}  // namespace impinge
