// SPDX-License-Identifier: GPL-3.0-or-later
// Methods cgal_first_hit and cgal_closest: first intersection with a ray from the centre, and distance of a
// point, by CGAL's tree of axis-aligned boxes with exact predicates and constructions in double.
#pragma once

#include <memory>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// mesh in the centre frame; its triangles are copied. Bytes are those of the heap, see heap_use.hpp.
std::unique_ptr<RadiusMethod> make_cgal_first_hit(const TriangleMesh& mesh);
// Distances from the nearest point of the surface.
std::unique_ptr<RadiusMethod> make_cgal_closest(const TriangleMesh& mesh);

}  // namespace impinge::lab
