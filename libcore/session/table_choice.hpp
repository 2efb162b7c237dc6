// SPDX-License-Identifier: GPL-3.0-or-later
// The cheapest table that keeps an accuracy, by what is proven about it before it is filled.
#pragma once

#include <span>
#include <vector>

#include "session/scene_plan.hpp"

namespace impinge {

/// What one look-up asks of a table, from NearFaces.
struct LookUpNeed {
  double radius = 0.0;  // mm, the largest near it
  double slope = 0.0;   // the largest tan psi near it
};

/// Error of first order of a table whose stencil radius is s (table/error_bound.hpp): radius * (exp(slope *
/// s) - 1), mm.
double first_order_error(const LookUpNeed& need, double stencil_radius);

/// Cost is counted in rays: working out an entry is one, a look-up that the table is not proven to keep
/// accurate is one, and reading the table is about a tenth of one. Among the given scheme and those with flat
/// cells, which are found without a search, and precisions of 2 to 0.05 degrees, the cheapest; rays alone
/// where they are cheaper still. What is chosen is an estimate; the accuracy is proven look-up by look-up
/// afterwards (keeps_accuracy()). Every look-up stands for `each` of them. 16 bits, float or double, the
/// smallest whose rounding is at most a quarter of the accuracy: `range` holds all radii.
TableChoice choose_table(std::span<const LookUpNeed> look_ups, std::size_t each, const RadiusRange& range,
                         double accuracy_mm, const AnyScheme& given);

}  // namespace impinge
