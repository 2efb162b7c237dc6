// SPDX-License-Identifier: GPL-3.0-or-later
// Refuses parameters that make no hip. Each function throws std::invalid_argument, one line that names the
// parameter, the reason and the cure.
#pragma once

#include "hip/hip_surface.hpp"

namespace impinge {

/// Refuses a parameter outside its range, conchoid_a without conchoid_b or the reverse, and a <= b.
void require_range(const HipParameters& parameters);

/// Refuses a neck that is too thin, thick or short to be told from head and shaft, and a rim too near to a
/// pole.
void require_shape(const HipSurface& hip);

/// Refuses a ball that penetrates the socket at rest (such as a cam under the socket that is higher than the
/// joint space), and parts of bone that touch the other bone. Sampled about every 2 degrees.
void require_free_at_rest(const HipSurface& hip);

}  // namespace impinge
