// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies for the diagrams of the thesis' sampling: what shape they have (Figure 29), and the rare case of a
// pole on an edge (Section 3.2, case 2).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "files/csv.hpp"
#include "hip/hip_parameters.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge::lab {

// A body, and what the diagrams call it.
struct NamedBody {
  std::string_view name;  // its kind
  TriangleMesh mesh;      // closed, centre frame
};

// The kinds that the thesis tells apart, from what the library makes: `sphere`, `near_spherical` (a ball with
// a cam), `star_shape` (the ball of the hip without its shaft), and one that is none of them, `femur` (with
// the shaft). Of about `faces` faces each, as in make_hip().
std::vector<NamedBody> bodies_by_shape(HipParameters shape, std::size_t faces);

// Columns alone, and the row of a closed mesh in the centre frame.
Table body_table();
void add_body(std::string_view name, const TriangleMesh& mesh, Table& bodies);  // Its row.

// The mesh moved across the z axis, by less than a face, so that the middle of an edge lies on +z exactly;
// its corners are rounded to 2^-20 mm first, which makes the sums exact. Chosen among the edges of the face
// that +z meets: the one whose middle is nearest. std::invalid_argument where +z meets no face.
TriangleMesh over_an_edge(TriangleMesh mesh);

}  // namespace impinge::lab
