// SPDX-License-Identifier: GPL-3.0-or-later
// What the diagrams of the thesis' sampling draw (Figures 25, 26 and 28 to 35): faces on the chart, the
// entries that they fill, and sections of bodies. Angles in degrees, lengths in mm; points and angles are
// rounded to 1e-4.
#pragma once

#include <string_view>

#include "files/csv.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {

// Columns alone, and the rows of one named mesh in the centre frame.
Table corner_table();  // the corners of every face
void add_corners(std::string_view name, const TriangleMesh& mesh, Table& corners);  // a row a corner

Table chart_table();  // the flat triangles that stand for every face (methods/chart.hpp)
// A row a corner of a triangle.
void add_chart(std::string_view name, const TriangleMesh& mesh, Table& chart);

Table coverage_table();  // which entries the faces fill (methods/chart_coverage.hpp)
// A row an entry that is filled.
void add_coverage(std::string_view name, const TriangleMesh& mesh, const Rsid& scheme, Table& coverage);

Table section_table();  // the surface in the plane y = 0
void add_section(std::string_view name, const TriangleMesh& mesh, Table& section);  // a row a segment

Table ray_table();  // its nearest and farthest radius along rays of that plane, evenly spread
void add_rays(std::string_view name, const TriangleMesh& mesh, double step_deg, Table& rays);  // a row a ray

}  // namespace impinge::lab
