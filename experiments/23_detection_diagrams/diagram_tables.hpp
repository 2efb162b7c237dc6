// SPDX-License-Identifier: GPL-3.0-or-later
// The data for diagrams of the thesis' sampling (Figures 25, 26 and 28 to 35): faces on the chart, the
// entries that they fill, and sections of bodies. Angles in degrees, lengths in mm; points and angles are
// rounded to 1e-4.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "files/csv.hpp"
#include "hip/hip_parameters.hpp"
#include "mesh/sphere_section.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {

// Each table has columns only; add_...() appends the rows of one named mesh in the centre frame.
Table corner_table();  // the corners of every face
void add_corners(std::string_view name, const TriangleMesh& mesh, Table& corners);  // a row a corner

Table chart_table();  // the flat triangles that stand for every face (methods/chart.hpp)
// One row per corner of a triangle.
void add_chart(std::string_view name, const TriangleMesh& mesh, Table& chart);

Table coverage_table();  // which entries the faces fill (methods/chart.hpp)
// One row per filled entry.
void add_coverage(std::string_view name, const TriangleMesh& mesh, const Rsid& scheme, Table& coverage);

Table section_table();  // the surface in the plane y = 0
void add_section(std::string_view name, const TriangleMesh& mesh, Table& section);  // a row a segment

Table ray_table();  // nearest and farthest radius along evenly spread rays of that plane
void add_rays(std::string_view name, const TriangleMesh& mesh, double step_deg, Table& rays);  // a row a ray

// Bodies for the diagrams of the thesis' sampling: kinds of shapes (Figure 29), and the rare case of a pole
// on an edge (Section 3.2, case 2).

// A body with its name in the diagrams.
struct NamedBody {
  std::string_view name;  // its kind
  TriangleMesh mesh;      // closed, centre frame
};

// The thesis' kinds of shapes, made from generated bodies of about `faces` faces (make_hip()): `sphere`,
// `near_spherical` (a ball with a cam), `star_shape` (the ball of the hip without its shaft), and `femur`
// (with the shaft), which is none of them.
std::vector<NamedBody> bodies_by_shape(HipParameters shape, std::size_t faces);

// The columns, and below the row of a closed mesh in the centre frame.
Table body_table();
void add_body(std::string_view name, const TriangleMesh& mesh, Table& bodies);  // adds its row

// Moves the mesh across the z axis, by less than a face, so that the middle of an edge lies exactly on +z.
// The corners are first rounded to 2^-20 mm, so that the sums are exact. Of the edges of the face that +z
// meets it takes the one whose middle is nearest. Throws std::invalid_argument if +z meets no face.
TriangleMesh over_an_edge(TriangleMesh mesh);

// The section of a surface by a plane through the origin.

// One segment for each face with corners on both sides of the plane n.x = 0, between the points where two of
// its edges cross it. `normal` may have any length above 0. A corner on the plane counts as in front (n.x >
// 0), so neighbouring faces cross at the same points and the section of a closed body is closed; a face that
// only touches the plane with such a corner gives a segment of length 0.
std::vector<Segment> plane_section(const TriangleMesh& mesh, const Vec3& normal);

}  // namespace impinge::lab
