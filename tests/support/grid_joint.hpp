// SPDX-License-Identifier: GPL-3.0-or-later
// Joints with corners on a small grid about the centre, so that every kind of edge-on face turns up, and
// their poses.
#pragma once

#include "mesh/ball_socket_pair.hpp"
#include "mesh/bodies.hpp"
#include "mesh/collinear.hpp"
#include "mesh/surface_vertices.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"

namespace impinge::test {

// A head with loose triangles and triangles that hang on it, and above it a sheet of loose triangles. Half of
// these are edge-on, but not all of the sheet.
inline BallSocketPair grid_joint(Dice& dice) {
  BallSocketPair joint{octahedron(2.0), {}};
  const auto add = [&](TriangleMesh& mesh, int lowest, int widest, bool hangs) {
    const auto corner = [&] {
      return Vec3(dice.whole(-widest, widest), dice.whole(-widest, widest), dice.whole(lowest, widest));
    };
    const bool edge_on = dice.whole(0, 1) == 0;
    const auto at = static_cast<VertexIndex>(dice.whole(0, 5));
    Triangle face;
    do {
      face = {hangs ? mesh.vertices[at] : corner(), corner(), corner()};
    } while (collinear(face[0], face[1], face[2]) ||
             (orientation(face[0], face[1], face[2]) == 0) != edge_on);
    add_face(mesh, face[0], face[1], face[2]);
    if (hangs) mesh.faces.back()[0] = at;
  };
  for (int faces = dice.whole(1, 4); faces > 0; --faces) add(joint.ball, -4, 4, dice.whole(0, 1) == 0);
  while (without_edge_on(joint.socket).faces.empty() || dice.whole(0, 2) > 0) add(joint.socket, 3, 5, false);
  return joint;
}

// One of the turns that take the grid to itself.
inline Eigen::Matrix3d grid_turn(Dice& dice) {
  const Eigen::Matrix3d quarter = (Eigen::Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
  const Eigen::Matrix3d third = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (int k = dice.whole(0, 5); k > 0; --k) turn = (k % 2 == 0 ? quarter : third) * turn;
  return turn;
}

}  // namespace impinge::test
