// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of a scanned hip: the error after each stage, and the pictures of Figure 37.
#pragma once

#include "19_slices_to_surface/slices_study.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// Columns alone, and the rows of one distance of the slices.
Table stage_table();
// Adds the rows of one distance of the slices, mm.
void add_stages(Table& table, double slice_mm, const SlicesResult& result);

// The decimated surfaces, one row a triangle, to a micrometre.
Table mesh_table(const SlicesResult& result);

// The pixels of the slice through the centre of the head, of both bones in one image.
Table slice_table(const Hip& hip, const SlicesOptions& options);

}  // namespace impinge::lab
