// SPDX-License-Identifier: GPL-3.0-or-later
// What the diagrams of the thesis' detection draw (Figures 26, 27 and 35): one vertex of a ball, looked up in
// the socket's table in a few poses, and the two scans of a pose in numbers. Lengths in mm.
#pragma once

#include <string_view>

#include "files/csv.hpp"
#include "gap/pose.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {

// The vertex nearest to the plane y = 0 among those at polar angles between the two limits (radians) and
// x > 0: one that a section by that plane shows. std::invalid_argument where there is none.
std::size_t vertex_in_section(const TriangleMesh& mesh, double phi_from, double phi_to);

// A vertex of the ball in a pose that has a name.
struct PosedVertex {
  std::string_view pose_name;  // name of the pose
  std::size_t vertex = 0;      // place among the vertices of the ball
  Vec3 x = Vec3::Zero();       // socket frame, mm
};

// Columns alone, and the row of one vertex: its angles and radius, the radius in the table, the gap.
Table lookup_table();
void add_lookup(const PosedVertex& vertex, const RadialTable<Rsid>& socket, Table& lookups);  // its row

// The entries round those that the look-up reads, with their weights: the rows and columns of its cell, and
// two more on either side.
Table excerpt_table();
void add_excerpt(const PosedVertex& vertex, const RadialTable<Rsid>& socket, Table& excerpt);  // their rows

// Columns alone, and both scans of a joint (socket frame, ball frame) in a pose, tables filled as in the
// thesis.
Table scan_table();
// Its two rows, one a scan.
void add_scans(const TriangleMesh& ball, const TriangleMesh& socket, const Pose& pose, const Rsid& scheme,
               Table& scans);

}  // namespace impinge::lab
