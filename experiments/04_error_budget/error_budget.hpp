// SPDX-License-Identifier: GPL-3.0-or-later
// The error budget of a gap: what each stage from the true surface to the stored number adds.
//
//   mesh         flat faces for a curved socket, measured where its surface has a formula
//   centre       the table is filled about a centre of rotation that is not the true one
//   table        interpolation between entries
//   arithmetic   double instead of extended precision in the look-up
//   storage      entries rounded to fewer bits
//
// A stage is the difference of two gaps of the same vertex, with and without what the stage adds, all else
// alike. The error of the last gap is therefore the sum of the stages, vertex by vertex. That the sums agree
// checks that no stage was left out.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "files/csv.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "sphere/stored_table.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {

// A joint whose error budget is made.
struct BudgetJoint {
  std::string name;                  // in the results
  BallSocketPair meshes;             // about the true centre, mm
  Vec3 wrong_centre = Vec3::Zero();  // the table is filled about this point, in the same frame
  // Radius of the true socket along a unit vector, mm; empty where nobody knows it.
  std::function<double(const Vec3&)> socket_radius;
};

// Gaps of the ball's vertices against the socket in the given pose, mm, one list per stage. The first list is
// the known truth; each further one has one more source of error. NaN where there is no gap.
struct Stage {
  std::string_view adds;    // the name of the stage that leads here; empty for the first
  std::vector<double> gap;  // mm, by vertex
};

// The exact stages, without any table: truth, mesh and centre.
std::vector<Stage> exact_stages(const BudgetJoint& joint);

// The stages of one table after the exact ones, for each way to store it.
struct StoredStages {
  std::string_view storage;   // double, float or uint16
  std::vector<Stage> stages;  // from the stage `table` on
};

// Vertices of the ball relative to the wrong centre, mm.
std::vector<Vec3> seen_from_wrong_centre(const BudgetJoint& joint);
TriangleMesh socket_about_wrong_centre(const BudgetJoint& joint);  // the socket's mesh in the same frame, mm

// Gaps of those vertices, mm, looked up in extended precision; stencil and entries are doubles.
template <SamplingScheme S>
std::vector<double> extended_gaps(const RadialTable<S>& table, const std::vector<Vec3>& vertices) {
  std::vector<double> gaps;
  gaps.reserve(vertices.size());
  for (const Vec3& x : vertices) {
    const Stencil stencil = table.scheme().stencil(x);
    long double radius = 0.0L;
    for (std::size_t k = 0; k < stencil.taps; ++k) {
      if (stencil.weight[k] > 0.0)
        radius += static_cast<long double>(stencil.weight[k]) * table.radii()[stencil.entry[k]];
    }
    const long double length =
        std::sqrt(static_cast<long double>(x.x()) * x.x() + static_cast<long double>(x.y()) * x.y() +
                  static_cast<long double>(x.z()) * x.z());
    gaps.push_back(table.is_rim_cell(stencil.cell) ? kNoSurface : static_cast<double>(radius - length));
  }
  return gaps;
}

// Gaps of those vertices, mm, in double, from any kind of table.
template <class AnyTable>
std::vector<double> computed_gaps(const AnyTable& table, const std::vector<Vec3>& vertices) {
  std::vector<double> gaps;
  gaps.reserve(vertices.size());
  for (const Vec3& x : vertices) gaps.push_back(table.radius_at(x) - x.norm());
  return gaps;
}

// The stages for the tables of one scheme, filled exactly and stored in double, in float and in 16 bits.
template <SamplingScheme S>
std::vector<StoredStages> table_stages(const BudgetJoint& joint, const S& scheme) {
  const std::vector<Vec3> vertices = seen_from_wrong_centre(joint);
  const RadialTable<S> table = fill_exact(socket_about_wrong_centre(joint), scheme, Layer::nearest);
  const std::vector<Stage> looked_up{{"table", extended_gaps(table, vertices)},
                                     {"arithmetic", computed_gaps(table, vertices)}};
  std::vector<StoredStages> all{{"double", looked_up}, {"float", looked_up}, {"uint16", looked_up}};
  all[1].stages.push_back({"storage", computed_gaps(FloatTable<S>(table), vertices)});
  all[2].stages.push_back({"storage", computed_gaps(Uint16Table<S>(table), vertices)});
  return all;
}

// The columns of error_budget.csv, without any row.
Table budget_table();

// Key columns for the rows of one table.
struct BudgetCase {
  std::string_view joint;      // its name
  std::string_view scheme;     // its name
  double precision_deg = 0.0;  // of the scheme
  std::string_view storage;    // of the entries
};

// Adds one row per stage, one for the total (last gap minus first) and one for the sum of the stages'
// largest values. A vertex without a gap in one of the stages is counted and left out of all. Throws
// std::logic_error if the stages of a vertex do not add up to its total.
void add_budget(Table& table, const BudgetCase& now, const std::vector<Stage>& stages);

// Estimates how far the surface behind a mesh stands out from its faces, mm, one value per face. It is the
// sagitta R - sqrt(R^2 - rho^2) of a sphere over the face: rho is the circumradius of the face, 1 / R the
// curvature across its most bent edge, which is the angle between two faces divided by the distance of their
// centroids. The sagitta is at most a half sphere's. The surface is taken as smooth, so noise of the vertices
// counts as curvature. Meant for a mesh of which nothing else is known.
std::vector<double> face_sagittas(const TriangleMesh& mesh);

// Adds a row of stage mesh_estimate.
void add_sagittas(Table& table, std::string_view joint, const std::vector<double>& sagittas);

}  // namespace impinge::lab
