// SPDX-License-Identifier: GPL-3.0-or-later
// The gnomonic cube map: a regular grid on each face of a cube, a_k = -1 + 2 k / n; see sphere/cube.hpp.
//
// No trigonometry in lookup, one division a coordinate. 1 / depth (depth = radius times the largest of |x|,
// |y|, |z|) of a plane is linear in (a, b): its bilinear interpolation reproduces a flat face exactly. Cells
// in the corners are 5.2 times smaller than those in the middle. N rho^2 -> 6 n^2 (sqrt(2) / n)^2 = 12 for
// the 6 n^2 + 2 entries that differ; the repeated ones on the edges of the cube add about 2 / n to it.
#pragma once

#include <numbers>
#include <string_view>

#include "sphere/cube.hpp"

namespace impinge {

/// The warp of CubeMap that divides the face evenly.
struct GnomonicCubeWarp {
  static constexpr std::string_view name = "cube_gnomonic";
  static constexpr std::string_view label = "Cube, gnomonic";
  static constexpr std::string_view citation =
      "Greene 1986, IEEE Computer Graphics and Applications 6(11):21-29";

  static double node(double t) { return t; }
  static double coordinate(double a) { return a; }

  /// Central projection from a plane at distance 1 makes no length longer.
  static constexpr double kLongestWay = std::numbers::sqrt2;
};

using CubeGnomonic = CubeMap<GnomonicCubeWarp>;

static_assert(PlaneExactScheme<CubeGnomonic>);

}  // namespace impinge
