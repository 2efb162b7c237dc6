// SPDX-License-Identifier: GPL-3.0-or-later
// What culling must not change: the answers of asking every vertex of both surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/culled_joint.hpp"
#include "gap/exact_side.hpp"
#include "mesh/surface_vertices.hpp"
#include "sphere/infinity.hpp"
#include "table/near_faces.hpp"

namespace impinge::test {

class EveryVertex {
 public:
  explicit EveryVertex(const BallSocketPair& joint)
      : joint_(joint),
        near_{NearFaces(joint.ball, 0.01), NearFaces(joint.socket, 0.01)},  // not those of CulledJoint
        used_{on_surface(joint.ball), on_surface(joint.socket)} {}

  bool impinged(const ScannedVertex& at, const Vec3& x) const {
    return exactly_impinged(at.scanned, near_[at.scanned == Surface::ball ? 1 : 0], x);
  }
  bool impinged(const Pose& pose) const {
    bool found = false;
    for_each(pose, [&](const ScannedVertex& at, const Vec3& x) { found = found || impinged(at, x); });
    return found;
  }
  std::optional<LeastGap> least_gap(const Pose& pose) const {
    std::optional<LeastGap> least;
    for_each(pose, [&](const ScannedVertex& at, const Vec3& x) {
      const bool ball = at.scanned == Surface::ball;
      if (x.isZero(0.0)) return;
      const double radius = ball ? near_[1].radius(x.normalized(), Layer::nearest)
                                 : near_[0].radius(x.normalized(), Layer::farthest);
      const double gap = ball ? radius - x.norm() : x.norm() - radius;
      if (gap < (least ? least->gap_mm : kInfinity)) least = LeastGap{gap, at};
    });
    return least;
  }

 private:
  // Every vertex of a face that covers directions, of both surfaces, in the order of scans and vertices, with
  // its place in the frame of the other one.
  template <class Visit>
  void for_each(const Pose& pose, const Visit& visit) const {
    for (std::size_t v = 0; v < used_[0].size(); ++v) {
      if (used_[0][v]) visit(ScannedVertex{Surface::ball, v}, to_socket(pose, joint_.ball.vertices[v]));
    }
    for (std::size_t v = 0; v < used_[1].size(); ++v) {
      if (used_[1][v]) visit(ScannedVertex{Surface::socket, v}, to_ball(pose, joint_.socket.vertices[v]));
    }
  }

  const BallSocketPair& joint_;
  std::array<NearFaces, 2> near_;
  std::array<std::vector<bool>, 2> used_;
};

}  // namespace impinge::test
