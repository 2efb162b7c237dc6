// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the cheapest table for an accuracy, before any table is filled.
#pragma once

#include <span>
#include <vector>

#include "session/scene_plan.hpp"

namespace impinge {

/// What decides the error of one look-up, from NearFaces.
struct LookUpNeed {
  double radius = 0.0;  // mm, the largest near the direction
  double slope = 0.0;   // the largest tan psi near the direction
};

/// First-order error bound of a table with stencil radius s, radians (table/error_bound.hpp): radius *
/// (exp(slope * s) - 1), mm.
double first_order_error(const LookUpNeed& need, double stencil_radius);

/// The cheapest of the given scheme and those with flat cells, at precisions of 2 to 0.05 degrees; rays alone
/// if they are cheaper. Cost is counted in rays: one for each entry that is worked out, one for each look-up
/// that the table is not proven to answer accurately, a tenth for reading the table. The choice rests on
/// estimates; the accuracy is proven for each look-up afterwards (keeps_accuracy()). Each of `look_ups`
/// stands for `each` look-ups. `range` holds all radii. Storage is the smallest of 16 bits, float and double
/// whose rounding is at most a quarter of the accuracy.
TableChoice choose_table(std::span<const LookUpNeed> look_ups, std::size_t each, const RadiusRange& range,
                         double accuracy_mm, const AnyScheme& given);

}  // namespace impinge
