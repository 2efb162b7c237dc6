// SPDX-License-Identifier: GPL-3.0-or-later
// Method embree_closest: distance of a point from the surface by Embree's point query. Embree walks its tree
// in float and leaves the distance from a triangle to the caller: that is in double here.
#pragma once

#include <memory>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// mesh in the centre frame; it is copied.
std::unique_ptr<RadiusMethod> make_embree_closest(const TriangleMesh& mesh);

}  // namespace impinge::lab
