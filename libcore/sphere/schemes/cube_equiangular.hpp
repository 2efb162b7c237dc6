// SPDX-License-Identifier: GPL-3.0-or-later
// The equi-angular cube map: grid lines at equal angles, a_k = tan(pi / 4 (-1 + 2 k / n)); see
// sphere/cube.hpp.
//
// Cells differ in area by a factor of sqrt(2). N rho^2 -> 6 n^2 (pi / (2 sqrt(2) n))^2 = 3 pi^2 / 4 = 7.402
// for the 6 n^2 + 2 entries that differ; the repeated ones on the edges of the cube add about 2 / n of it.
#pragma once

#include <cmath>
#include <string_view>

#include "sphere/cube.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// The warp of CubeMap that divides the angle evenly.
struct EquiangularCubeWarp {
  static constexpr std::string_view name = "cube_equiangular";
  static constexpr std::string_view label = "Cube, equi-angular";
  static constexpr std::string_view citation =
      "Ronchi, Iacono and Paolucci 1996, J. Comput. Phys. 124:93-114";

  /// Exact in the middle and at the ends, where tan(pi / 4) would be one rounding short of 1.
  static double node(double t) { return std::abs(t) == 1.0 ? t : std::tan(kPi / 4.0 * t); }
  static double coordinate(double a) { return std::atan(a) * (4.0 / kPi); }

  /// With (a, b) = (tan p, tan q), A = 1 + a^2, B = 1 + b^2 and D = 1 + a^2 + b^2 a way has
  ///   ds^2 = (A^2 B dp^2 - 2 a b A B dp dq + A B^2 dq^2) / D^2 <= (1 + a^2 b^2 / D) (1 + (1 + 2 |a b|) / D)
  ///   h^2
  /// for |dp|, |dq| <= h. D >= 1 + 2 |a b| makes that at most 2 (1 + (a b)^2 / (1 + 2 |a b|)) h^2 <= 8/3 h^2,
  /// which the diagonals at the corners of the cube reach; h = pi / 4 for a step of 1 in t.
  static constexpr double kLongestWay = 1.632993161855452 * kPi / 4.0;  // sqrt(8/3) pi / 4
};

using CubeEquiangular = CubeMap<EquiangularCubeWarp>;

static_assert(PlaneExactScheme<CubeEquiangular>);

}  // namespace impinge
