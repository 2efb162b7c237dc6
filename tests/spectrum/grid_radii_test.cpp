// SPDX-License-Identifier: GPL-3.0-or-later
// The radii along a grid are those of rays against all faces.
#include "spectrum/grid_radii.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

TEST(GridRadii, AreThoseOfRays) {
  const GaussGrid grid(40);
  const BallSocketPair pair = make_ball_socket_pair(600);
  for (const TriangleMesh& mesh :
       {pair.ball, pair.socket, octahedron(20.0), cone(), sphere(10.0, 200, {3.0, 1.0, -2.0})}) {
    for (const Layer layer : {Layer::nearest, Layer::farthest}) {
      const auto radii = grid_radii(grid, mesh, layer);
      const RayCaster caster(mesh);
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const double expected = caster.cast(grid.direction(i / grid.columns(), i % grid.columns()), layer);
        ASSERT_EQ(std::isnan(radii[i]), std::isnan(expected)) << i;
        if (!std::isnan(expected)) {
          ASSERT_NEAR(radii[i], expected, 1e-11) << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace impinge
