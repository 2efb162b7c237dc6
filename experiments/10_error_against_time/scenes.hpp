// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the benchmark: generated pairs, and real joints where they are given.
#pragma once

#include <cstddef>
#include <string>

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {

// The pair of `faces` triangles a model, its ball turned until the cam is under the socket; free by 1 mm.
BenchmarkScene generated_scene(std::size_t faces);

// A hip of a preset with about so many triangles a model, as a real joint; "hip_PRESET_TRIANGLES".
BenchmarkScene hip_scene(const std::string& preset, std::size_t faces);

// Pose number `turn` of a motion about the axis, the ball a little off the centre: 5 degrees a turn to 115
// degrees, after which it begins again.
Pose motion_pose(const Vec3& axis, int turn);

// A real joint, its ball turned by 10 degrees about +x.
BenchmarkScene real_scene(std::string name, BallSocketPair pair);

}  // namespace impinge::lab
