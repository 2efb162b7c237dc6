// SPDX-License-Identifier: GPL-3.0-or-later
// A surface with holes, such as a femoral head cut off at its neck, continued over all directions.
#pragma once

#include <string_view>
#include <vector>

#include "spectrum/gauss_grid.hpp"

namespace impinge {

/// How a hole is filled. Neither changes a value that is there.
///   membrane  zero Laplacian in the hole, equal to the values round it: the steady temperature. Of all
///             continuous fillings it has the least sum l (l + 1) |a_lm|^2 and no extreme of its own; it has
///             a kink at the edge, which puts power into high degrees.
///   plate     least integral of the squared Laplacian, the least sum l^2 (l + 1)^2 |a_lm|^2: a bent plate,
///             which goes on with the slope of the surface and has no kink. It may overshoot.
enum class Filling { membrane, plate };

std::string_view name_of(Filling filling);  // "membrane" or "plate"

/// Replaces the NaNs among `values`, one for each direction of the grid, row by row. Finite volumes on the
/// grid, solved directly. std::invalid_argument for another number of values or if all are NaN;
/// std::runtime_error if the equations cannot be solved.
std::vector<double> fill_holes(const GaussGrid& grid, std::vector<double> values, Filling filling);

}  // namespace impinge
