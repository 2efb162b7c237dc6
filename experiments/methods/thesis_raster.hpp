// SPDX-License-Identifier: GPL-3.0-or-later
// Filling an RSID table as the thesis does (Section 3.2, Algorithm 1, Figures 30-34): faces are drawn as flat
// triangles on the (theta, phi) grid and the distances of their corners interpolated linearly.
//
// As this follows the text, it is not the radius of the mesh: edges are straight in (theta, phi), not great
// circles, and the distance is linear instead of p / (n.u). Where the thesis is silent: a face across theta =
// 0 is unrolled, and grid lines through an edge belong to both faces.
#pragma once

#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

// Draws all faces into an existing table, over what it holds, as Algorithm 1 does; the rim is not masked.
// mesh in the centre frame.
void draw_thesis(const TriangleMesh& mesh, Layer layer, RadialTable<Rsid>& table);

// A new table, filled by draw_thesis(), with its rim masked.
RadialTable<Rsid> fill_thesis(const TriangleMesh& mesh, const Rsid& scheme, Layer layer);

// Bound on |fill_thesis() - exact radius| at every entry, mm; infinite if a face is edge-on. It is E0 + the
// largest min(E1 + E2, E3) of a face, and holds where the surface continues across each edge: all over a
// closed star-shaped body, and inside the rim of an open one.
//
// Let f(u) = p / (n.u) be the plane of a face, psi its largest incidence angle, T = tan psi and r its largest
// radius. The drawn triangle spans dtheta and dphi; s and c are the largest sin(phi) and |cos(phi)| on it.
//   Interpolation. Along a straight line of the chart with velocity w, f changes its slope by at most
//     r (1 + 2 T^2) (w_phi^2 + s^2 w_theta^2) + r T c (s w_theta^2 + 2 |w_theta w_phi|):
//   the Hessian of f on the sphere has the eigenvalues r (1 + 2 tan^2 psi) and r, its gradient the length r
//   tan psi, and the line the geodesic curvature of the last bracket. Linear interpolation errs by half the
//   mean of this over the corners; the mean of a squared deviation is at most a quarter of the range squared:
//     E1 = r/8 ((1 + 2 T^2) (dphi^2 + s^2 dtheta^2) + T c (s dtheta^2 + 2 dtheta dphi)).
//   Displaced edges. A drawn edge and the great circle through its ends are no farther apart than
//     e = asin((c dtheta sqrt(s^2 dtheta^2 + 4 dphi^2) + dphi^2 + s^2 dtheta^2) / 8),
//   an eighth of the curve's acceleration. A direction in between is drawn from the wrong one of two faces
//   that agree on the edge:  E2 = r T e + r (exp(T_all e) - 1),  with T_all the largest T of the mesh and T,
//   r taken to psi + e.
//   Poles. E1 and E2 grow fast for a face that covers much of the azimuth next to a pole. There the corners
//   tell more. Along any path |d ln r / ds| <= T_all, no direction of the drawn triangle is farther than
//   D = min(dphi + s dtheta, twice the distance to the pole) from a corner, and the drawn value is a mean of
//   the corners' radii:
//     E3 = r (exp(T_all D) - 1).
//   Rounding. An entry within 1e-9 of a step (at most 1.6e-9 rad) of a drawn triangle, along phi and along
//   theta, gets the value of a point of it, and angles of entries and corners are off by less than 1e-14. So
//   the point is within delta = 4e-9 rad of the entry, and the surface there within first_order_share(T_all,
//   delta) (error_bound.hpp) of itself. Its last term covers the rounding of radii, 86 u (1 + T), and of tan
//   psi, 80 u (1 + T), which changes E1, E2 and E3 by at most twice as much of themselves; a bound above the
//   largest radius of the mesh, R, holds by itself. So E0 = R first_order_share(T_all, delta) is added. For
//   faces of about 1e-5 rad and less it is most of the bound.
double thesis_raster_bound(const TriangleMesh& mesh);

}  // namespace impinge::lab
