// SPDX-License-Identifier: GPL-3.0-or-later
// consumer BALL SOCKET: the smallest gap at a vertex of the ball, mm. Both meshes have the centre as their
// origin.
#include <algorithm>
#include <cstdio>

#include "kernels/gap_kernels.hpp"
#include "mesh/io.hpp"
#include "table/exact_raster.hpp"

int main(int, char** files) {
  using namespace impinge;
  const TriangleMesh ball = read_mesh(files[1]);
  const auto socket = fill_exact(read_mesh(files[2]), CubeGnomonic::with_precision(0.5), Layer::nearest);
  const auto table = packed_table<float>(socket);
  const auto vertices = packed_vertices<float>(ball.vertices);
  std::vector<float> gap(vertices.size());
  scan_gaps(table, vertices, Pose{}, Surface::ball, gap);
  std::erase_if(gap, [](float g) { return g != g; });  // where the socket is not met
  std::printf("%.3f\n", static_cast<double>(std::ranges::min(gap)));
}
