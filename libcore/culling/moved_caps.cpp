// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/moved_caps.hpp"

namespace impinge {

CapMove::CapMove(ScannedSurface surface, const Pose& at)
    : scanned(surface), pose(at), rotation(at.rotation), translation(at.translation) {
  own = rotation.transpose() * translation;
  shift = translation.norm();
  if (scanned == ScannedSurface::ball) return;
  rotation.transposeInPlace();
  std::swap(own, translation);
  own = -own;
  translation = -translation;
}

}  // namespace impinge
