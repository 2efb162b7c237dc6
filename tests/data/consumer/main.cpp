// SPDX-License-Identifier: GPL-3.0-or-later
// consumer BALL SOCKET: a right hip from two scans as they come (mm, +x right, +y to the front, +z up).
#include <cstdio>
#include <utility>

#include "gap/simd/exact_cells.hpp"
#include "hip/joint.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/io.hpp"

int main(int, char** files) {
  using namespace impinge;
  // Frame and centre: both meshes about the centre of rotation, which is fitted to the ball.
  JointInput input;
  input.ball = {files[1], read_mesh(files[1])};
  input.socket = {files[2], read_mesh(files[2])};
  input.side = Side::right;
  const Joint joint = assemble_joint(std::move(input));

  // 500 poses of internal rotation at 90 degrees of flexion: the gaps of the faces, of all vertices of the
  // ball.
  const ExactCells cells = exact_cells(joint.socket.mesh, Layer::nearest);
  const auto vertices = packed_vertices<float>(joint.ball.mesh.vertices);
  std::vector<float> gaps(vertices.size());
  std::size_t touching = 0;
  for (int k = 0; k < 500; ++k) {
    const Motion motion{.flexion = 90.0, .internal_rotation = 0.1 * k};
    const Pose pose{joint_rotation(motion, Side::right), Vec3::Zero()};
    scan_gaps(cells, vertices, pose, Surface::ball, gaps);
    std::size_t impinged = 0;
    for (const float gap : gaps) impinged += gap <= 0.0F ? 1U : 0U;  // NaN faces no socket
    touching += impinged > 0 ? 1U : 0U;
  }
  std::printf("a vertex of the ball impinges in %zu of 500 poses\n", touching);

  // First contact of that motion, of the whole surfaces: none before `low`, contact at `high`.
  const TurnLimits limits({joint.ball.mesh, joint.socket.mesh});
  const JointTurn turn = joint_turn({.flexion = 90.0}, motion_name("internal_rotation"), Side::right);
  const TurnLimit limit = limits.first_contact(turn, 90.0);
  std::printf("internal_rotation %.3f %.3f\n", limit.low_deg, limit.high_deg);
}
