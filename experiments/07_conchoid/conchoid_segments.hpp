// SPDX-License-Identifier: GPL-3.0-or-later
// How evenly rays at equal angles cut the conchoid, from its origin and from what may be called its centre
// (Figure 53).
#pragma once

#include <cstddef>
#include <span>

#include "curves/conchoid.hpp"
#include "harness/provenance.hpp"

namespace impinge::lab {

// conchoid_spacing.csv: every segment, for each origin and number of rays.
Result conchoid_segments(const ConchoidShape& shape, std::span<const std::size_t> ray_counts);

// conchoid_origins.csv: what the segments of ever more rays approach, arc per angle, for each origin.
Result conchoid_origins(const ConchoidShape& shape);

}  // namespace impinge::lab
