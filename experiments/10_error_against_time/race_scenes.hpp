// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes of the race: generated pairs, and real joints where they are given.
#pragma once

#include <cstddef>

#include "methods/race_scene.hpp"

namespace impinge::lab {

// The pair of `faces` triangles a model, its ball turned until the cam is under the socket; free by 1 mm.
RaceScene generated_scene(std::size_t faces);

// A real joint, its ball turned by 10 degrees about +x.
RaceScene real_scene(std::string name, BallSocketPair pair);

}  // namespace impinge::lab
