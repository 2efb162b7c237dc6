// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that a case of radii tests: ours and others.
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

// The questions for the methods of one case, and the surface.

// A surface and the directions along which it is asked.
struct StabilityScene {
  TriangleMesh mesh;  // centre frame, mm
  // Of any length above 0. Rays are cast along them. Tables are looked up along them, and also tested at
  // their own entries.
  std::vector<Vec3> directions;
  // Indices of two directions that are the same but written differently; answers must have the same bits.
  std::vector<std::array<std::size_t, 2>> twins;
  double precision_deg = 10.0;  // of the tables
};

// Does the ray along x meet the face? Exact; u is x normalised.
bool is_met(const TriangleCone& cone, const Vec3& x, const Vec3& u);

// The rasteriser's rays without a table: the nearest radius() of all faces whose cone contains the direction,
// decided exactly. This fills every table, and answers along any direction.
PointQuery make_cone_rays(const TriangleMesh& mesh);

// A method to test, or why it cannot be tested.
struct StabilityMethod {
  PointCase maker;                  // how it is prepared
  Scalar scalar = Scalar::float64;  // that it computes in, or stores
  std::string refused = {};         // one line if it refuses; else empty
};

// cone_rays, and every method for points with a name for stiff cases: ours, brute force, libraries. A scheme
// without a table at the scene's precision appears with its refusal. The scene must outlive the methods.
std::vector<StabilityMethod> stability_methods(const StabilityScene& scene, const BoundOptions& search);

// The entries of every scheme at a precision.
struct SchemeEntries {
  std::string scheme;            // its name
  std::vector<Vec3> directions;  // unit vectors
};
std::vector<SchemeEntries> scheme_entries(double precision_deg);  // for each scheme that has the precision

}  // namespace impinge::lab
