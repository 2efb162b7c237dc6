// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest distance between ball and socket in a pose, from pairs of triangles: the reference for methods
// that answer for a whole pose.
#pragma once

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {

// Euclidean, mm, up to rounding; 0 if the surfaces meet (decided exactly). Triangles of the ball that cannot
// be nearer than the nearest vertex are skipped.
double surface_distance(const BenchmarkScene& scene);

}  // namespace impinge::lab
