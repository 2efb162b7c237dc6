// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the benchmark: generated pairs, and real joints where they are given.
#pragma once

#include <cstddef>

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {

// The pair of `faces` triangles a model, its ball turned until the cam is under the socket; free by 1 mm.
BenchmarkScene generated_scene(std::size_t faces);

// A real joint, its ball turned by 10 degrees about +x.
BenchmarkScene real_scene(std::string name, BallSocketPair pair);

}  // namespace impinge::lab
