// SPDX-License-Identifier: GPL-3.0-or-later
// The study of the sampling error: what a look-up answers beside the truth, for one scheme and precision
// after the other. Each adds its rows to three tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "04_sampling_error/nearest_entry.hpp"
#include "04_sampling_error/sampling_error.hpp"
#include "files/csv.hpp"
#include "harness/error_summary.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "table/exact_raster.hpp"
#include "table/probe_directions.hpp"
#include "table/table_bound.hpp"

namespace impinge::lab {

// Directions close to a pole are within this many spacings of it.
inline constexpr double kPolarCells = 3.0;

// A surface with a formula, and where it is examined.
struct ExaminedSurface {
  RadialSurface surface;  // its formula
  Probes probes;          // its truth along the directions of the study
};

// What the rows of all schemes share, and the tables that they fill.
struct SamplingStudy {
  double radius = 22.0;  // mm, of the head without its bump: the r of Eq. 7
  // `uniform` ones, then some close to the poles, then those through vertices and edges of the head.
  std::vector<Vec3> directions;
  std::size_t uniform = 0;                // number of the uniform ones
  std::vector<ExaminedSurface> formulas;  // examined along all but the last
  TriangleMesh head;                      // of the generated joint, mm
  Probes head_mesh;                       // the truth is the mesh
  Probes head_formula;                    // the truth is the smooth surface behind it
  RadialSurface plane;                    // on which the bound of a face is checked
  std::vector<Vec3> away_from_poles;      // uniform directions more than 10 degrees from them
  std::vector<EdgeShape> edges;           // on which the bound of an edge is checked
  Table errors;                           // sampling_error.csv
  Table proven;                           // sampling_error_proven.csv
  bool prove = true;  // works out the bound of each table of the head: most of the time at fine precision
  Table surfaces;     // sampling_error_surfaces.csv
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
// Surfaces, directions and truth; tables without a row.
SamplingStudy make_sampling_study(const StudyOptions& options);

// What the rows of one scheme and precision share.
struct StudyCase {
  std::string_view scheme;            // its name
  double precision = 0.0;             // degrees, as asked for
  std::vector<NearestEntry> nearest;  // of each direction of the study
  Gap gap;                            // the widest that was found
};

// Adds a row to `surfaces`. Errors in mm, in the order of the probes.
void add_surface_row(SamplingStudy& study, const StudyCase& now, const ExaminedSurface& examined,
                     std::string_view interpolant, const std::vector<double>& errors);

// One promise about errors, and how near to it they come.
struct BoundCheck {
  std::string_view promise;  // its name
  std::string_view surface;  // its name
  std::string_view reach;    // which radius of the scheme the bound takes, if any
};
// Adds a row to `bounds`: errors and their bounds, probe by probe, mm.
void add_bound_row(SamplingStudy& study, const StudyCase& now, const BoundCheck& check,
                   const std::vector<double>& errors, const std::vector<double>& bounds);

// The three look-ups in a table with entries entry_radius(i).
template <SamplingScheme S, class EntryRadius>
void add_lookups(SamplingStudy& study, const StudyCase& now, const S& scheme, const ExaminedSurface& examined,
                 const EntryRadius& entry_radius) {
  const auto& u = study.directions;
  const auto add = [&](std::string_view interpolant, const auto& answer) {
    add_surface_row(study, now, examined, interpolant, errors_at(examined.probes, answer));
  };
  add("nearest", [&](std::size_t k) { return entry_radius(now.nearest[k].entry); });
  add("smooth", [&](std::size_t k) { return smooth_radius(scheme, u[k], entry_radius); });
  if constexpr (PlaneExactScheme<S>) {
    add("mesh_exact", [&](std::size_t k) { return plane_exact_radius(scheme, u[k], entry_radius); });
  }
}

// Rows of surfaces with a formula: tables of any size, of which only the entries read are computed.
template <SamplingScheme S>
void add_formulas(SamplingStudy& study, const StudyCase& now, const S& scheme) {
  for (const ExaminedSurface& examined : study.formulas) {
    const RadialSurface& surface = examined.surface;
    const auto entry_radius = [&](std::size_t i) { return surface.radius(scheme.direction(i)); };
    add_lookups(study, now, scheme, examined, entry_radius);
    std::vector<double> bounds;
    for (const std::size_t k : examined.probes.place) {
      bounds.push_back(nearest_bound(surface, study.directions[k], scheme.direction(now.nearest[k].entry)));
    }
    const auto errors =
        errors_at(examined.probes, [&](std::size_t k) { return entry_radius(now.nearest[k].entry); });
    add_bound_row(study, now, {"nearest", surface.name, ""}, errors, bounds);
  }
}

// Adds a row to `proven`. Throws std::runtime_error where the largest error measured is above the bound.
void add_proven_row(SamplingStudy& study, const StudyCase& now, double measured_max, const TableBound& bound);

// Row of `errors` for a scheme that is not measured: the formula alone.
template <SamplingScheme S>
void add_formula(SamplingStudy& study, const S& scheme, double precision) {
  study.errors.add_row({S::name, precision, thesis_sampling_error(study.radius, scheme.equator_points()),
                        100.0 * thesis_relative_error(scheme.equator_points()), Cell(), Cell()});
}

// Rows of the head, whose table is really filled.
template <SamplingScheme S>
void add_head(SamplingStudy& study, const StudyCase& now, const S& scheme) {
  const RadialTable<S> table = fill_exact(study.head, scheme, Layer::farthest);
  const auto errors =
      errors_at(study.head_mesh, [&](std::size_t k) { return table.radius_at(study.directions[k]); });
  const ErrorSummary summary = summarise_errors(errors, study.uniform);
  study.errors.add_row({now.scheme, now.precision,
                        thesis_sampling_error(study.radius, scheme.equator_points()),
                        100.0 * thesis_relative_error(scheme.equator_points()), summary.max, summary.rms});
  if (study.prove) add_proven_row(study, now, summary.max, table_bound(study.head, table, Layer::farthest));
  const auto entry_radius = [radii = table.radii()](std::size_t i) { return radii[i]; };
  ExaminedSurface head;
  head.surface.name = "head_mesh";
  head.probes = study.head_mesh;
  add_lookups(study, now, scheme, head, entry_radius);
  head.surface.name = "head_mesh_against_formula";
  head.probes = study.head_formula;
  add_lookups(study, now, scheme, head, entry_radius);
}

// What is promised of linear interpolation on one plane, away from the poles and at one, and across one edge,
// with the covering radius and with the stencil radius in the place of rho.
template <SamplingScheme S>
void add_bounds(SamplingStudy& study, const StudyCase& now, const S& scheme) {
  const auto check = [&](std::string_view promise, const RadialSurface& surface,
                         const std::vector<Vec3>& directions, const auto& bound) {
    const Probes probes = probes_of(surface, directions);
    const auto entry_radius = [&](std::size_t i) { return surface.radius(scheme.direction(i)); };
    const auto errors =
        errors_at(probes, [&](std::size_t k) { return smooth_radius(scheme, directions[k], entry_radius); });
    for (const auto& [reach, rho] :
         {std::pair{"covering", scheme.covering_radius()}, {"stencil", scheme.stencil_radius()}}) {
      std::vector<double> bounds;
      for (const std::size_t k : probes.place) bounds.push_back(bound(directions[k], rho));
      add_bound_row(study, now, {promise, surface.name, reach}, errors, bounds);
    }
  };
  const auto planar = [&](const Vec3& u, double rho) { return planar_bound(study.plane, scheme, u, rho); };
  check("planar_face", study.plane, study.away_from_poles, planar);
  check("planar_face_at_pole", study.plane,
        polar_directions(kPolarCells * now.precision * kDegree, study.uniform / 4), planar);
  for (const EdgeShape& shape : study.edges) {
    const EdgeSurface edge = edge_surface("edge_" + std::to_string(std::lround(shape.tilt_deg)), shape);
    check("edge", edge.surface, directions_along(shape, scheme.covering_radius(), study.uniform / 4),
          [&](const Vec3& u, double rho) { return edge_bound(edge, scheme, u, rho); });
  }
}

// All rows of a scheme at a precision, degrees, measured.
template <SamplingScheme S>
void add_scheme(SamplingStudy& study, const S& scheme, double precision) {
  StudyCase now;
  now.scheme = S::name;
  now.precision = precision;
  now.nearest = nearest_entries(scheme, study.directions);
  now.gap = widest_gap(scheme, study.directions, now.nearest);
  add_head(study, now, scheme);
  add_formulas(study, now, scheme);
  add_bounds(study, now, scheme);
}

}  // namespace impinge::lab
