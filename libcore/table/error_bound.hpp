// SPDX-License-Identifier: GPL-3.0-or-later
// A proven bound on the error of interpolation in a table, direction by direction.
//
// With psi the angle between a ray and the normal of the face that it meets, a layer's radius is continuous
// and |d ln r / ds| <= tan psi. In a cell that no rim crosses there is a path from any direction u to each
// tap i, at most the stencil radius s long. With T_i the largest tan psi of the faces within s of the tap,
//   |r_i - r(u)| <= r_i (exp(T_i s) - 1),
// and the interpolated value, a mean of the r_i with weights w_i, errs by at most sum w_i r_i (exp(T_i s) -
// 1). First order in s: safe, and loose where a face is smooth and large (the error there is of second
// order).
//
// Roundings. The condition of a face (kPlaneRoundings in surface_plane.hpp) is at most 4 root(1 + T^2) <= 4
// (1 + T) by the choice of its plane (sphere/face_plane.hpp), u = 2^-53. So the entry and the radius along u
// are each off by 84 u (1 + T) of themselves, tan psi by 80 u (1 + T), the look-up by 17 u. The bound adds
// 512 u (1 + T_i) r_i exp(T_i s), which covers its own rounding up to s = 3, and widens s by
// direction_doubt(). Theorem 3 (slope).
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

/// By how much rounding may move an entry or a line between entries, radians. An azimuth of t turns of a
/// curve is 2 pi t with at most 8 roundings of t, t <= equator_points() for every spiral: 5.6e-15 a turn; all
/// other angles are within one turn.
template <SamplingScheme S>
double direction_doubt(const S& scheme) {
  return 1e-14 * (2.0 + static_cast<double>(scheme.equator_points()));
}

inline constexpr double kFirstOrderRounding = 512.0 * 0x1p-53;  // share of a radius, per unit of 1 + tan psi

/// How much a radius may change within `angle` radians where tan psi <= slope, as a share of the radius.
inline double first_order_share(double slope, double angle) {
  const double grown = std::expm1(slope * angle);
  return grown + kFirstOrderRounding * (1.0 + slope) * (1.0 + grown);
}

/// Largest tan psi within the stencil radius of each entry; infinite near a face whose plane holds the
/// centre, 0 where there is no face. mesh in the centre frame. Of schemes of the library; for one of your own
/// see own_scheme.hpp.
template <SamplingScheme S>
std::vector<float> largest_slopes(const TriangleMesh& mesh, const S& scheme);

/// Bound on |table.radius_at(x) - radius of the mesh along x|, mm, for a table filled exactly and its
/// largest_slopes(). kNoSurface where the table has no surface; infinite where the
/// bound is above the radius itself and says nothing.
template <SamplingScheme S>
double error_bound_at(const RadialTable<S>& table, const std::vector<float>& slopes, const Vec3& x) {
  const Stencil stencil = table.scheme().stencil(x);
  if (table.is_rim_cell(stencil.cell)) return kNoSurface;
  const double reach = table.scheme().stencil_radius() + direction_doubt(table.scheme());
  double bound = 0.0;
  double radius = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const std::size_t i = stencil.entry[k];
    if (stencil.weight[k] == 0.0) continue;
    const double share = stencil.weight[k] * table.radii()[i];
    radius += share;
    bound += share * first_order_share(slopes[i], reach);
  }
  return bound > radius ? std::numeric_limits<double>::infinity() : bound;
}

}  // namespace impinge
