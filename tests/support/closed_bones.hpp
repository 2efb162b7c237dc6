// SPDX-License-Identifier: GPL-3.0-or-later
// Bones of which CGAL and solid angles tell whether they meet.
#pragma once

#include <cmath>
#include <vector>

#include "mesh/bodies.hpp"
#include "mesh/star_shape.hpp"
#include "reference/meeting_surfaces.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"

namespace impinge::test {

// Of a closed mesh.
inline bool holds(const TriangleMesh& mesh, const Vec3& x) {
  double angle = 0.0;
  for (const Face& face : mesh.faces)
    angle += solid_angle(corner(mesh, face, 0) - x, corner(mesh, face, 1) - x, corner(mesh, face, 2) - x);
  return std::abs(angle) > 2.0 * kPi;
}

// A head with a spike, and wings that go behind the wall of the socket; the bones are closed.
struct ClosedBones {
  explicit ClosedBones(const Vec3& wing_at = {30.0, 22.0, 0.0}) {
    joint.ball.vertices[5] *= 1.45;
    head = joint.ball;
    for (const double side : {1.0, -1.0})
      wings.push_back(moved(octahedron(3.0), wing_at.cwiseProduct(Vec3(side, 1.0, 1.0))));
    for (const TriangleMesh& wing : wings) joint.ball = joined(joint.ball, wing);
    const TriangleMesh inner = joint.socket;
    TriangleMesh back = inner;
    for (Vec3& x : back.vertices) x *= 32.0 / 26.0;
    joint.socket = with_back(inner, back);
  }
  bool meet(const Eigen::Matrix3d& rotation, const Vec3& shift = Vec3::Zero()) const {
    const TriangleMesh ball = moved(turned(joint.ball, rotation), shift);
    return surfaces_meet(ball, joint.socket) || holds(ball, joint.socket.vertices[0]) ||
           holds(joint.socket, ball.vertices[0]) || holds(joint.socket, ball.vertices.back()) ||
           holds(joint.socket, ball.vertices[head.vertices.size()]);
  }
  BallSocketPair joint{sphere(20.0, 60), cup(26.0, 70.0, 60)};
  TriangleMesh head;
  std::vector<TriangleMesh> wings;
};

}  // namespace impinge::test
