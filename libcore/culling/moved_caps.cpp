// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/moved_caps.hpp"

namespace impinge {

CapMove::CapMove(ScannedSurface surface, const Pose& at)
    : scanned(surface),
      pose(at),
      rotation(at.rotation.cast<float>()),
      shift(static_cast<float>(at.translation.norm())) {
  const Vec3 in_ball_frame = at.rotation.transpose() * at.translation;
  if (scanned == ScannedSurface::ball) {
    translation = at.translation.cast<float>();
    own = in_ball_frame.cast<float>();
  } else {
    rotation.transposeInPlace();
    translation = -in_ball_frame.cast<float>();
    own = -at.translation.cast<float>();
  }
}

}  // namespace impinge
