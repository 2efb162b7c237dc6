// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the sampling error: the answer of a look-up compared with the truth. Each scheme and precision
// adds its rows to the tables.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "files/csv.hpp"
#include "harness/statistics.hpp"
#include "sphere/scheme.hpp"
#include "sphere/scheme_list.hpp"
#include "table/exact_raster.hpp"
#include "table/table_bound.hpp"

namespace impinge::lab {

// The thesis' error formula, and the theoretical error of a look-up on a plane.

// Eq. 7 of the thesis, mm: sqrt(2) pi r / n for n entries on the equator. It is half the diagonal of a cell
// there, along a sphere of radius r. A point of the surface may be so far from an entry; it is no error of a
// radius.
inline double thesis_sampling_error(double radius, std::size_t equator_points) {
  return std::sqrt(2.0) * kPi * radius / static_cast<double>(equator_points);
}

// Eq. 8: Eq. 7 as a share of the radius.
inline double thesis_relative_error(std::size_t equator_points) {
  return thesis_sampling_error(1.0, equator_points);
}

// The answer of a table along u if its entry i holds entry_radius(i). It is linear in r and, away from a rim,
// equal to RadialTable::radius_at() bit for bit. Only the entries that are read are computed.
template <SamplingScheme S, class EntryRadius>
double smooth_radius(const S& scheme, const Vec3& u, const EntryRadius& entry_radius) {
  const Stencil stencil = scheme.stencil(u);
  double radius = 0.0;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    if (stencil.weight[k] > 0.0) radius += stencil.weight[k] * entry_radius(stencil.entry[k]);
  }
  return radius;
}

// The plane n.x = p, used up to an incidence of `steepest` radians. Directions are unit vectors.
struct SlantedPlane {
  Vec3 normal = Vec3(0.48, 0.6, 0.64);  // n, unit: no line of a grid runs along or round it
  double distance = 22.0;               // p, mm
  double steepest = 75.0 * kDegree;     // below 90 degrees

  bool covers(const Vec3& u) const { return angle_between(normal, u) <= steepest; }
  double radius(const Vec3& u) const { return distance / normal.dot(u); }
  // tan psi = |grad r| / r; psi is the angle from the direction to the normal.
  double slope(const Vec3& u) const { return normal.cross(u).norm() / normal.dot(u); }
};

// |answer - truth| of a look-up on that plane, mm.
template <SamplingScheme S>
double error_on_plane(const SlantedPlane& plane, const S& scheme, const Vec3& u) {
  const auto entry_radius = [&](std::size_t i) { return plane.radius(scheme.direction(i)); };
  return std::abs(smooth_radius(scheme, u, entry_radius) - plane.radius(u));
}

// Bound on this error, mm, if a circle of angular radius `rho` holds the taps: rho^2 / 2 times the largest r
// (1 + 2 tan^2 psi) at u and the taps, which is the larger eigenvalue of the Hessian of r.
template <SamplingScheme S>
double planar_bound(const SlantedPlane& plane, const S& scheme, const Vec3& u, double rho) {
  const auto curvature = [&plane](const Vec3& x) {
    const double slope = plane.slope(x);
    return plane.radius(x) * (1.0 + 2.0 * slope * slope);
  };
  const Stencil stencil = scheme.stencil(u);
  double largest = curvature(u);
  for (std::size_t k = 0; k < stencil.taps; ++k)
    largest = std::max(largest, curvature(scheme.direction(stencil.entry[k])));
  return 0.5 * rho * rho * largest;
}

// What the rows of all schemes share, and the tables of the study.
struct SamplingStudy {
  double radius = 22.0;  // mm, of the head without its bump; r in Eq. 7
  TriangleMesh head;     // of the generated joint, mm
  // First `uniform` uniform directions, then some close to the poles, then some through vertices and edges.
  std::vector<Vec3> directions;
  std::size_t uniform = 0;            // number of the uniform ones
  std::vector<double> truth;          // radius of the head along each direction, mm
  std::vector<Vec3> away_from_poles;  // uniform directions more than 10 degrees from the poles
  Table errors;                       // sampling_error.csv
  Table proven;                       // sampling_error_proven.csv
  bool prove = true;  // bound each table of the head, which takes most of the time at fine precision
  Table sphere;       // sampling_error_sphere.csv
  Table bounds;       // sampling_error_bounds.csv
};

// How much is examined.
struct StudyOptions {
  std::size_t faces = 12000;       // of the head
  std::size_t uniform = 200000;    // directions
  std::size_t polar = 1000;        // directions at the poles for each precision
  std::vector<double> precisions;  // degrees
  std::uint64_t seed = 0;          // of the uniform directions
};
// Makes surfaces, directions and truth, and tables without rows.
SamplingStudy make_sampling_study(const StudyOptions& options);

// What the rows of one scheme and precision share.
struct StudyCase {
  std::string_view scheme;  // its name
  double precision = 0.0;   // degrees, as asked for
};

// Adds a row to `proven`. Throws std::runtime_error if the largest measured error, mm, is above the bound.
void add_proven_row(SamplingStudy& study, const StudyCase& now, double measured_max, const TableBound& bound);

// Adds a row to `errors` for a scheme that is not measured, with the formula alone.
template <SamplingScheme S>
void add_formula(SamplingStudy& study, const S& scheme, double precision) {
  study.errors.add_row({S::name, precision, thesis_sampling_error(study.radius, scheme.equator_points()),
                        100.0 * thesis_relative_error(scheme.equator_points()), Cell(), Cell()});
}

// Adds the rows for the head, whose table is really filled.
template <SamplingScheme S>
void add_head(SamplingStudy& study, const StudyCase& now, const S& scheme) {
  const RadialTable<S> table = fill_exact(study.head, scheme, Layer::farthest);
  std::vector<double> errors;
  errors.reserve(study.truth.size());
  for (std::size_t k = 0; k < study.truth.size(); ++k)
    errors.push_back(std::abs(table.radius_at(study.directions[k]) - study.truth[k]));
  const ErrorSummary summary = summarise_errors(errors, study.uniform);
  study.errors.add_row({now.scheme, now.precision,
                        thesis_sampling_error(study.radius, scheme.equator_points()),
                        100.0 * thesis_relative_error(scheme.equator_points()), summary.max, summary.rms});
  if (study.prove) add_proven_row(study, now, summary.max, table_bound(study.head, table, Layer::farthest));
}

// Adds a row to `sphere`: the distance that Eq. 7 stands for, and the error of a radius.
template <SamplingScheme S>
void add_sphere(SamplingStudy& study, const StudyCase& now, const S& scheme) {
  double largest = 0.0;
  for (const Vec3& u : study.directions) {
    const double radius = smooth_radius(scheme, u, [&](std::size_t) { return study.radius; });
    largest = std::max(largest, std::abs(radius - study.radius));
  }
  study.sphere.add_row({now.scheme, now.precision, study.radius * scheme.covering_radius(), largest});
}

// Adds rows to `bounds`, with the covering radius and with the stencil radius as rho.
template <SamplingScheme S>
void add_bounds(SamplingStudy& study, const StudyCase& now, const S& scheme) {
  const SlantedPlane plane;
  const double rounding = 1e-12 * study.radius;
  for (const auto& [reach, rho] :
       {std::pair{"covering", scheme.covering_radius()}, {"stencil", scheme.stencil_radius()}}) {
    double largest = 0.0;
    double share = 0.0;
    for (const Vec3& u : study.away_from_poles) {
      if (!plane.covers(u)) continue;
      const double error = error_on_plane(plane, scheme, u);
      largest = std::max(largest, error);
      share = std::max(share, (error - rounding) / planar_bound(plane, scheme, u, rho));
    }
    study.bounds.add_row({now.scheme, now.precision, reach, largest, share, share <= 1.0});
  }
}

// Adds all measured rows of a scheme at a precision, degrees.
template <SamplingScheme S>
void add_scheme(SamplingStudy& study, const S& scheme, double precision) {
  const StudyCase now{S::name, precision};
  add_head(study, now, scheme);
  if constexpr (std::same_as<S, Rsid>) add_sphere(study, now, scheme);  // the scheme of Table 5
  add_bounds(study, now, scheme);
}

}  // namespace impinge::lab
