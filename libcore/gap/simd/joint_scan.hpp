// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Both scans of a joint, for many poses: tables and vertices in the form that kernels read are made once.
#pragma once

#include <span>
#include <utility>

#include "gap/simd/gap_kernels.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

/// The tables and vertices of both surfaces, each in its own centre frame.
template <class Table>
struct PackedJoint {
  using Real = typename Table::Real;  // float or double, as the kernel works

  Table ball_table;             // asked by the socket's vertices
  Table socket_table;           // asked by the ball's vertices
  PackedVertices<Real> ball;    // mm
  PackedVertices<Real> socket;  // mm
};

/// Packs meshes in their centre frames, mm, with the tables that were filled from them.
template <class Table>
PackedJoint<Table> packed_joint(Table ball_table, Table socket_table, const TriangleMesh& ball,
                                const TriangleMesh& socket) {
  using Real = typename Table::Real;
  return {std::move(ball_table), std::move(socket_table), packed_vertices<Real>(ball.vertices),
          packed_vertices<Real>(socket.vertices)};
}

/// Writes the gaps of all vertices, mm, as in gap/simd/gap_kernels.hpp. Each span has the size of its
/// surface.
template <class Table>
void scan_joint(const PackedJoint<Table>& joint, const Pose& pose,
                std::span<typename PackedJoint<Table>::Real> ball_gap,
                std::span<typename PackedJoint<Table>::Real> socket_gap) {
  scan_gaps(joint.socket_table, joint.ball, pose, Surface::ball, ball_gap);
  scan_gaps(joint.ball_table, joint.socket, pose, Surface::socket, socket_gap);
}

}  // namespace impinge
