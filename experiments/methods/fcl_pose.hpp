// SPDX-License-Identifier: GPL-3.0-or-later
// Methods fcl_collide and fcl_distance: one answer for a whole pose, by FCL's trees of oriented boxes.
#pragma once

#include <memory>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// Do they touch? 0 mm if so, else NaN: FCL says no more. Bytes as in heap_use.hpp.
std::unique_ptr<RadiusMethod> make_fcl_collide(const BenchmarkScene& scene);

// Smallest distance between the surfaces, mm, 0 where they touch, to the last digits (no tolerance is given
// away).
std::unique_ptr<RadiusMethod> make_fcl_distance(const BenchmarkScene& scene);

}  // namespace impinge::lab
