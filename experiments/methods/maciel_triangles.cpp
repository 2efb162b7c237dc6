// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/maciel_triangles.hpp"

namespace impinge::lab {

bool MacielTriangles::touches(const Pose& pose) {
  bool touching = false;
  for (std::size_t i = 0; i < socket_.size(); ++i) {
    const Vec3 y = to_ball(pose, socket_[i]);
    gap_[i] = y.norm() - radius_at(table_, ball_, y);
    touching = touching || gap_[i] <= 0.0;  // a NaN is not
  }
  return touching;
}

}  // namespace impinge::lab
