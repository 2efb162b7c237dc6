// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/spiral_radii.hpp"

#include "sphere/arc_steps.hpp"
#include "sphere/conchoid_steps.hpp"
#include "sphere/height_steps.hpp"

namespace impinge {

template double spiral_covering_radius(const ArcSteps&);
template double spiral_covering_radius(const ConchoidSteps&);
template double spiral_covering_radius(const HeightSteps&);
template double spiral_stencil_radius(const ArcSteps&);
template double spiral_stencil_radius(const ConchoidSteps&);
template double spiral_stencil_radius(const HeightSteps&);

}  // namespace impinge
