// SPDX-License-Identifier: GPL-3.0-or-later
// From the rows of a drawn tile to those of the table, with vector instructions; bit for bit the same on
// every instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "table/layer.hpp"

namespace impinge {

/// How numbers are stored: code = (q - smallest) / step to the nearest, from 0 to 65534. Not used for floats.
struct StoredSteps {
  float smallest = 0.0F;  // 1 / mm, code 0
  float per_step = 0.0F;  // 1 / step
};

/// A row of the canvas, `count` entries of it, as the table stores it.
void store_row(const float* q, std::size_t count, const StoredSteps& steps, std::uint16_t* row);
void store_row(const float* q, std::size_t count, const StoredSteps& steps, float* row);

/// Bit k: entry k of the first 64 of the row has no surface.
std::uint64_t empty_entries(const float* q, Layer layer);

}  // namespace impinge
