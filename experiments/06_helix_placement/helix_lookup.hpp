// SPDX-License-Identifier: GPL-3.0-or-later
// What Eq. 10's look-up costs on the ball, by where the entries of the helix stand.
#pragma once

#include <cstddef>
#include <span>

#include "harness/provenance.hpp"

namespace impinge::lab {

// helix_lookup_error.csv: error of the interpolated radius of the generated ball (its smooth surface, mm) for
// each number of turns, over the directions of a Fibonacci lattice.
Result helix_lookup_errors(std::span<const std::size_t> turns);

}  // namespace impinge::lab
