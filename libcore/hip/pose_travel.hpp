// SPDX-License-Identifier: GPL-3.0-or-later
// Do poses move the ball farther than a joint allows? Then they are in another unit or frame, or turn about
// another point, than was meant.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "gap/pose.hpp"
#include "hip/joint.hpp"

namespace impinge {

/// A warning in one line if poses move the ball's centre farther from the socket's than the ball's radius:
/// how many do, the first of them (counted from `first`), how far, and what to do. The advice is what brings
/// all of them back: translations in m or cm, or a turn about the origin of the input frame. Empty if no pose
/// does. `pose_at` gives each of `poses` poses of the ball, in the centre frame of the socket.
std::string doubtful_travel(const Joint& joint, std::size_t poses,
                            const std::function<Pose(std::size_t)>& pose_at, std::size_t first = 0);

}  // namespace impinge
