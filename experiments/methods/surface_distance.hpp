// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest distance between ball and socket in a pose, by going through pairs of triangles: the oracle of
// methods that answer for a whole pose.
#pragma once

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {

// mm, to the last digits; 0 where the surfaces meet (decided exactly). Triangles of the ball that cannot be
// nearer than a vertex is are passed over.
double surface_distance(const BenchmarkScene& scene);

}  // namespace impinge::lab
