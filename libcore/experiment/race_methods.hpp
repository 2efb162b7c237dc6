// SPDX-License-Identifier: GPL-3.0-or-later
// All methods of the race on one scene. The scene outlives them.
#pragma once

#include <cstddef>
#include <vector>

#include "contenders/radius_method.hpp"

namespace impinge {

// Every scheme of every precision (degrees) it can have, in double, float and 16 bits; those whose entries
// lie on a solid also with inverse depths, as SCHEME_mesh_exact. Filled exactly.
std::vector<MethodMaker> table_methods(const RaceScene& scene, const std::vector<double>& precisions);

// rsid_thesis and usid_thesis: the tables of the thesis, filled as the thesis does, in double.
std::vector<MethodMaker> thesis_methods(const RaceScene& scene, const std::vector<double>& precisions);

// What libraries offer, brute force, and distance grids with so many nodes a side.
std::vector<MethodMaker> other_methods(const RaceScene& scene, const std::vector<std::size_t>& grid_nodes);

}  // namespace impinge
