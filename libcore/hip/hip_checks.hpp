// SPDX-License-Identifier: GPL-3.0-or-later
// What makes no hip. Each function throws std::invalid_argument, one line that names the parameter, the
// reason and the cure.
#pragma once

#include "hip/hip_surface.hpp"

namespace impinge {

/// A parameter outside of its range, or one half of a conchoid.
void require_range(const HipParameters& parameters);

/// A neck too thin, too thick or too short to be seen between head and shaft; a rim too near to a pole.
void require_shape(const HipSurface& hip);

/// A ball that penetrates the socket at rest, as a cam does that is higher than the joint space where it is
/// covered, or parts of bone that touch what they face. Sampled at every second degree or so.
void require_free_at_rest(const HipSurface& hip);

}  // namespace impinge
