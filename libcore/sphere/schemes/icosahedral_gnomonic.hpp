// SPDX-License-Identifier: GPL-3.0-or-later
// The gnomonic icosahedral grid: the flat faces divided into equal triangles and projected to the sphere; see
// sphere/icosahedral_grid.hpp.
//
// No trigonometry in lookup, one division. 1 / depth (depth along the normal of the icosahedron's face) of a
// plane is linear in the barycentric weights, so that its interpolation reproduces a flat face exactly. The
// widest cell is the one in the middle of a face: rho = atan((3 - sqrt(5)) / n) where it is centred there,
// N rho^2 -> 10 (3 - sqrt(5))^2 = 5.836.
#pragma once

#include <cstddef>
#include <string_view>

#include "sphere/icosahedral_grid.hpp"

namespace impinge {

/// The warp of IcosahedralGrid that divides the flat face evenly.
struct GnomonicIcosahedralWarp {
  static constexpr std::string_view name = "icosahedral_gnomonic";
  static constexpr std::string_view label = "Icosahedral, gnomonic";
  static constexpr std::string_view citation =
      "Baumgardner and Frederickson 1985, SIAM J. Numer. Anal. 22:1107-1115";

  static constexpr bool kFlatCells = true;
  static double weight(std::size_t k, std::size_t) { return static_cast<double>(k); }
  static Vec3 fractions(const Vec3& lambda) { return lambda; }
  static void widen(TriangleRange&) {}

  /// An edge of a flat cell is 1 / n of the icosahedron's edge, and its plane is cos(corner angle) from the
  /// centre: as an angle it is no longer than their ratio, sqrt(3) (3 - sqrt(5)) / n.
  static constexpr double kLongestWay = 1.7320508075688772 * Icosahedron::kTangent;
};

using IcosahedralGnomonic = IcosahedralGrid<GnomonicIcosahedralWarp>;

static_assert(PlaneExactScheme<IcosahedralGnomonic>);

}  // namespace impinge
