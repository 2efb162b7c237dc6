// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: the radius of the exact rasteriser at every entry within the tolerance, but for the share that
// may be off; the same with any number of threads, and once the table is forgotten and filled again.
#include "methods/fill.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

TEST(Filling, HasTheRadiiOfTheRasteriser) {
  const TriangleMesh socket = make_ball_socket_pair(1000).socket;
  const auto scheme = CubeGnomonic::with_precision(4.5);
  const RadialTable<CubeGnomonic> exact = fill_exact(socket, scheme, Layer::nearest);
  const auto directions = std::make_shared<const FloatDirections>(scheme);
  for (const FillCase& method : cases_of(fill_methods(), &Method::fill)) {
    for (const int threads : {1, 2, 3}) {
      const TableFilling table = method.make({socket, Layer::nearest, scheme, directions}, threads);
      table.fill();
      table.forget();
      table.fill();
      std::size_t off = 0;
      for (std::size_t e = 0; e < scheme.size(); ++e) {
        const double expected = exact.radii()[e];
        if (!std::isnan(expected) && !(std::abs(table.radius(e) - expected) <= table.tolerance())) ++off;
      }
      EXPECT_LE(static_cast<double>(off), method.most_off * static_cast<double>(scheme.size()))
          << method.name;
    }
  }
}

}  // namespace
}  // namespace impinge::lab
