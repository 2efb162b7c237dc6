// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the radius along every ray of the range, that of the faces but for what float takes; NaN where
// there is no surface; nothing is written beyond the range, whatever its size
#include "methods/embree_fill.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "support/directions.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

TEST(EmbreeFill, RadiiAlongAllRaysOfARange) {
  const TriangleMesh socket = make_ball_socket_pair(1000).socket;
  const std::vector<Vec3> directions = test::random_directions(500, 11);
  const RayCaster caster(socket);
  const EmbreeScene scene(socket, EmbreeQuality::robust);
  for (const RayRange rays : {RayRange{0, 500}, RayRange{3, 4}, RayRange{17, 48}, RayRange{100, 100}}) {
    std::vector<float> radii(directions.size(), -1.0F);
    cast_coherent(scene, RayDirections(directions), rays, radii);
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const bool asked = i >= rays.first && i < rays.end;
      const double expected = asked ? caster.cast(directions[i], Layer::nearest) : -1.0;
      ASSERT_EQ(std::isnan(radii[i]), std::isnan(expected)) << i;
      if (std::isnan(expected)) continue;
      ASSERT_NEAR(static_cast<double>(radii[i]), expected, 1e-4) << i;
    }
  }
}

}  // namespace
}  // namespace impinge::lab
