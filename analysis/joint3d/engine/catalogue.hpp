// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to choose from: hips, their parameters, motions, schemes and precisions.
#pragma once

#include "hip/hip_parameters.hpp"
#include "js_values.hpp"

namespace impinge {

val catalogue();

// {head_radius: 24, ...}, without the side.
val parameters_value(const HipParameters& parameters);

}  // namespace impinge
