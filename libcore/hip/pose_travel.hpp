// SPDX-License-Identifier: GPL-3.0-or-later
// Do poses move the ball farther than a joint allows? Then they are in another unit, about another point or
// of another frame than was meant.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "gap/pose.hpp"
#include "hip/joint.hpp"

namespace impinge {

/// One line where poses move the ball's centre farther from the socket's than the radius of the ball: how
/// many do, the first (counted from `first`), how far, and what to do, by what would bring all of them back:
/// translations in m or cm, a turn about the origin of the frame of the input. Empty where none does.
/// `pose_at` gives each of `poses` poses, of the ball in the centre frame of the socket.
std::string doubtful_travel(const Joint& joint, std::size_t poses,
                            const std::function<Pose(std::size_t)>& pose_at, std::size_t first = 0);

}  // namespace impinge
