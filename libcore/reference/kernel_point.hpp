// SPDX-License-Identifier: GPL-3.0-or-later
// Points for CGAL: double coordinates, exact predicates.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "sphere/direction.hpp"

namespace impinge {

/// CGAL's kernel with such numbers and predicates.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Kernel::Point_3 kernel_point(const Vec3& x) { return {x.x(), x.y(), x.z()}; }  // the same point

}  // namespace impinge
