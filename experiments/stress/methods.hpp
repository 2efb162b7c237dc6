// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that a case of radii goes through: ours, and the others beside them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "methods/points.hpp"
#include "stress/family.hpp"
#include "table/table_bound.hpp"

namespace impinge::lab {

// What the methods of one case are asked, and of which surface.

// A surface and the directions along which it is asked.
struct StabilityScene {
  TriangleMesh mesh;  // centre frame, mm
  // Of any length above zero. Rays are cast along them; tables are looked up there, and examined at their own
  // entries too.
  std::vector<Vec3> directions;
  // Places of two directions that are the same one, differently written: answers have the same bits.
  std::vector<std::array<std::size_t, 2>> twins;
  double precision_deg = 10.0;  // of the tables
};

// Does the ray along x meet the face? Exact; u is x normalised.
bool is_met(const TriangleCone& cone, const Vec3& x, const Vec3& u);

// The rays of the rasteriser without a table: of all faces whose cone contains the direction, exactly, the
// nearest radius(). What fills every table, asked along any direction.
PointQuery make_cone_rays(const TriangleMesh& mesh);

// A method that is asked, or why it cannot be.
struct StabilityMethod {
  PointCase maker;                  // how it comes to be
  Scalar scalar = Scalar::float64;  // that it computes in, or stores
  std::string refused = {};         // the one line of a refusal; else empty
};

// cone_rays, and of all that answer points those with a name for stiff cases: ours, brute force, libraries. A
// scheme that has no table at the precision of the scene is there with its refusal. The scene outlives the
// methods.
std::vector<StabilityMethod> stability_methods(const StabilityScene& scene, const BoundOptions& search);

// The entries of every scheme at a precision.
struct SchemeEntries {
  std::string scheme;            // its name
  std::vector<Vec3> directions;  // unit vectors
};
std::vector<SchemeEntries> scheme_entries(double precision_deg);  // of each scheme that has the precision

}  // namespace impinge::lab
