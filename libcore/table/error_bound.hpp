// SPDX-License-Identifier: GPL-3.0-or-later
// A proven bound on the error of interpolation in a table, direction by direction: sum w_i r_i (exp(T_i s) -
// 1) by Theorem 3 (slope). Here w_i are the weights and r_i the radii of the taps, s is the stencil radius,
// and T_i the largest tan psi of the faces within s of the tap, psi the angle between a ray and the normal of
// its face. The bound is of first order in s: safe, but loose on large smooth faces, where the error is of
// second order.
//
// Roundings, u = 2^-53. The condition of a face (kPlaneRoundings in surface_plane.hpp) is at most 4 root(1 +
// T^2) <= 4 (1 + T) by the choice of its plane (sphere/face_plane.hpp). So the entry and the radius along a
// direction are each off by 84 u (1 + T) of themselves, tan psi by 80 u (1 + T), the look-up by 17 u. The
// bound adds 512 u (1 + T_i) r_i exp(T_i s), which covers its own rounding up to s = 3, and widens s by
// direction_doubt().
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {

/// By how much rounding may move an entry or a line between entries, radians. On a spiral the azimuth after t
/// turns is 2 pi t with at most 8 roundings of t <= equator_points(), 5.6e-15 a turn. All other angles are
/// within one turn.
template <SamplingScheme S>
double direction_doubt(const S& scheme) {
  return 1e-14 * (2.0 + static_cast<double>(scheme.equator_points()));
}

inline constexpr double kFirstOrderRounding = 512.0 * 0x1p-53;  // share of a radius, per unit of 1 + tan psi

/// How much a radius may change within `angle` radians if tan psi <= slope, as a share of the radius.
inline double first_order_share(double slope, double angle) {
  const double grown = std::expm1(slope * angle);
  return grown + kFirstOrderRounding * (1.0 + slope) * (1.0 + grown);
}

/// For each entry the largest tan psi within the stencil radius: infinite near a face whose plane holds the
/// centre, 0 without a face. `mesh` is in the centre frame. For schemes of the library; for your own include
/// own_scheme.hpp.
template <SamplingScheme S>
std::vector<float> largest_slopes(const TriangleMesh& mesh, const S& scheme);

/// Bound on |table.radius_at(x) - radius of the mesh along x|, mm, for a table filled exactly and its
/// largest_slopes(). kNoSurface if the table has no answer; infinite if the bound is above the radius itself
/// and says nothing.
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
