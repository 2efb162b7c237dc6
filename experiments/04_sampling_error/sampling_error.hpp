// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' error formula, and the errors that a look-up really makes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "04_sampling_error/lookup.hpp"
#include "04_sampling_error/radial_surface.hpp"

namespace impinge::lab {

// Eq. 7 of the thesis, mm: sqrt(2) pi r / n for n entries on the equator. Half the diagonal of a cell there,
// measured along a sphere of radius r: how far a point of the surface may be from an entry, not how wrong a
// radius is.
inline double thesis_sampling_error(double radius, std::size_t equator_points) {
  return std::sqrt(2.0) * kPi * radius / static_cast<double>(equator_points);
}

// Eq. 8: the same as a share of the radius.
inline double thesis_relative_error(std::size_t equator_points) {
  return thesis_sampling_error(1.0, equator_points);
}

// Directions along which a surface is examined: places in a list of directions, and the true radius (mm)
// there.
struct Probes {
  std::vector<std::size_t> place;  // in the list of directions, ascending
  std::vector<double> truth;       // of each place, mm
};

// Those of the directions that the surface covers.
Probes probes_of(const RadialSurface& surface, std::span<const Vec3> directions);

// |answer(k) - truth| for every probe, mm; `answer` takes a place in the list of directions.
template <class Answer>
std::vector<double> errors_at(const Probes& probes, const Answer& answer) {
  std::vector<double> errors(probes.place.size());
  for (std::size_t k = 0; k < errors.size(); ++k)
    errors[k] = std::abs(answer(probes.place[k]) - probes.truth[k]);
  return errors;
}

// Bounds on the error of a look-up, mm, for surfaces with a formula. Each is what theory promises; the
// experiment on the sampling error measures whether it holds for the stencils as they are.

// Of the nearest entry v: |r(v) - r(u)| <= r (exp(T angle) - 1), because |grad ln r| = tan psi. T is the
// largest of tan psi at u, at v and half-way, r the smaller radius of the two.
double nearest_bound(const RadialSurface& surface, const Vec3& u, const Vec3& v);

// Largest r (1 + 2 tan^2 psi) at u and the taps: the larger eigenvalue of the Hessian of a planar face.
template <SamplingScheme S>
double planar_curvature(const RadialSurface& plane, const S& scheme, const Vec3& u) {
  const auto at = [&plane](const Vec3& x) {
    const double slope = plane.slope(x);
    return plane.radius(x) * (1.0 + 2.0 * slope * slope);
  };
  const Stencil stencil = scheme.stencil(u);
  double largest = at(u);
  for (std::size_t k = 0; k < stencil.taps; ++k)
    largest = std::max(largest, at(scheme.direction(stencil.entry[k])));
  return largest;
}

// Linear interpolation within one planar face by taps that a circle of angular radius `rho` holds:
// rho^2 / 2 times the curvature.
template <SamplingScheme S>
double planar_bound(const RadialSurface& plane, const S& scheme, const Vec3& u, double rho) {
  return 0.5 * rho * rho * planar_curvature(plane, scheme, u);
}

// The same across an edge between two planes: the slope of r jumps there by r^2 |q1 - q2|, q = n / p, and an
// interpolation across a kink errs by half of it times rho.
template <SamplingScheme S>
double edge_bound(const EdgeSurface& edge, const S& scheme, const Vec3& u, double rho) {
  const Stencil stencil = scheme.stencil(u);
  double radius = edge.surface.radius(u);
  for (std::size_t k = 0; k < stencil.taps; ++k)
    radius = std::max(radius, edge.surface.radius(scheme.direction(stencil.entry[k])));
  const double kink = radius * radius * (edge.inverse_1 - edge.inverse_2).norm();
  return 0.5 * rho * kink + planar_bound(edge.surface, scheme, u, rho);
}

}  // namespace impinge::lab
